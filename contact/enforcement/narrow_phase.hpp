// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/formulations/contact_formulation.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// Finds the contact points of formulations on all threads, always in the same order.
class NarrowPhase {
 public:
  /// Takes the contact points of a formulation in the order of its rows, and has it remember them but in
  /// trials.
  template <class F, class Take>
  void visit_points(F& formulation, const ContactStepContext& context, const Take& take);

 private:
  template <class F, class Take>
  void detect_in_chunks(F& formulation, const ContactStepContext& context, const Take& take);

  std::vector<std::vector<ContactPoint>> chunks_;  // scratch of each thread
  std::vector<ContactPoint> all_points_;           // scratch
};

/// Detects contact points chunk by chunk on all threads. They are taken in order while other threads work on
/// later chunks.
template <class F, class Take>
void NarrowPhase::detect_in_chunks(F& formulation, const ContactStepContext& context, const Take& take) {
  if constexpr (requires { formulation.begin_detection(context); }) formulation.begin_detection(context);
  const std::size_t n_rows = formulation.n_rows();
  const std::size_t n_chunks = (n_rows + rows_per_chunk - 1) / rows_per_chunk;
  const int n_threads = threads_for(n_rows * 10);
  chunks_.resize(std::max(chunks_.size(), static_cast<std::size_t>(n_threads)));
  const auto detect = [&](std::size_t i, std::vector<ContactPoint>& points) {
    points.clear();
    const CandidateRows rows{i * rows_per_chunk, std::min((i + 1) * rows_per_chunk, n_rows)};
    formulation.detect(context, rows, points);
    return rows;
  };
  const auto take_points = [&](CandidateRows rows, const std::vector<ContactPoint>& points) {
    if (!context.is_trial) formulation.update(context, rows, points);
    for (const ContactPoint& point : points) take(point);
  };
  if (n_threads == 1) {
    for (std::size_t i = 0; i < n_chunks; ++i) take_points(detect(i, chunks_.front()), chunks_.front());
    return;
  }
#pragma omp parallel for ordered schedule(dynamic, 1) num_threads(n_threads)
  for (std::size_t i = 0; i < n_chunks; ++i) {
    std::vector<ContactPoint>& points = chunks_[static_cast<std::size_t>(omp_get_thread_num())];
    const CandidateRows rows = detect(i, points);
#pragma omp ordered
    take_points(rows, points);
  }
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
