// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/enforcement/shared_points.hpp"
#include "contact/formulations/contact_formulation.hpp"
#include "core/base/ordered_pipeline.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// Finds the contact points of a formulation on all threads and ranks, always in the same order.
class NarrowPhase {
 public:
  /// Ranks must outlive it.
  explicit NarrowPhase(Ranks& ranks) : shared_(ranks) {}

  /// Takes the contact points of a formulation in the order of its rows, and has it remember them but in
  /// trials.
  template <class F, class Take>
  void visit_points(F& formulation, const ContactStepContext& context, const Take& take);

 private:
  template <class F, class Take>
  void detect_in_chunks(F& formulation, const ContactStepContext& context, const Take& take);

  OrderedPipeline<std::vector<ContactPoint>> chunks_;
  SharedPoints shared_;
  std::vector<ContactPoint> all_points_;  // scratch
};

/// Detects contact points chunk by chunk on all threads. They are taken in order while others are detected;
/// where ranks share them, once all ranks have told theirs.
template <class F, class Take>
void NarrowPhase::detect_in_chunks(F& formulation, const ContactStepContext& context, const Take& take) {
  if constexpr (requires { formulation.begin_detection(context); }) formulation.begin_detection(context);
  const std::size_t n_rows = formulation.n_rows();
  const std::size_t n_chunks = (n_rows + rows_per_chunk - 1) / rows_per_chunk;
  const auto rows_of = [&](std::size_t i) {
    return CandidateRows{i * rows_per_chunk, std::min((i + 1) * rows_per_chunk, n_rows)};
  };
  const auto take_chunk = [&](std::size_t i, std::span<const ContactPoint> points) {
    if (!context.is_trial) formulation.update(context, rows_of(i), points);
    for (const ContactPoint& point : points) take(point);
  };
  const bool are_shared = shared_.begin(n_chunks);
  const std::size_t first = are_shared ? shared_.first_own() : 0;
  const std::size_t end = are_shared ? shared_.end_own() : n_chunks;
  chunks_.run(
      end - first, threads_for(n_rows * 10),
      [&](std::size_t i, std::vector<ContactPoint>& points) {
        points.clear();
        formulation.detect(context, rows_of(first + i), points);
      },
      [&](std::size_t i, const std::vector<ContactPoint>& points) {
        shared_.add(first + i, points);
        if (!are_shared) take_chunk(i, points);
      });
  if (!are_shared) return;
  shared_.gather();
  for (std::size_t i = 0; i < n_chunks; ++i) take_chunk(i, shared_.of(i));
}

template <class F, class Take>
void NarrowPhase::visit_points(F& formulation, const ContactStepContext& context, const Take& take) {
  if constexpr (requires { formulation.complete(context, std::span(all_points_)); }) {
    all_points_.clear();
    detect_in_chunks(formulation, context, [&](const ContactPoint& point) { all_points_.push_back(point); });
    formulation.complete(context, std::span(all_points_));
    for (const ContactPoint& point : all_points_) take(point);
  } else {
    detect_in_chunks(formulation, context, take);
  }
}

}  // namespace contactsim
