// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/formulations/contact_formulation.hpp"
#include "contact/geometry/float_lanes.hpp"
#include "contact/mesh/pair_lists.hpp"
#include "core/base/bytes_of.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

/// Of the candidates of a search those that may meet while contact nodes stay in a range of motion: an inner
/// list, by which narrow phases leave out what is far.
template <class Row, class Partner>
class CloseCandidates {
 public:
  using Candidates = PairLists<Row, Partner>;
  struct Entry {
    Row row;
    std::uint32_t position;  ///< among the candidates
  };

  /// Finds them anew, on all threads.
  ///   find  (CandidateRows, const auto& take): take(row, position) for those of a chunk of rows, in order
  template <class Find>
  void renew(const Candidates& candidates, const Find& find) {
    const std::size_t n_rows = candidates.n_rows();
    chunks_.resize((n_rows + rows_per_chunk - 1) / rows_per_chunk);
    parallel_for_uneven(chunks_.size(), threads_for(n_rows * 10), [&](std::size_t i) {
      std::vector<Entry>& chunk = chunks_[i];
      chunk.clear();
      find(CandidateRows{i * rows_per_chunk, std::min((i + 1) * rows_per_chunk, n_rows)},
           [&](Row row, std::size_t position) {
             chunk.push_back({row, static_cast<std::uint32_t>(position)});
           });
    });
  }
  /// The same by some pairs at a time.
  ///   Pairs     n_float_lanes pairs at most with their positions
  ///   may_meet  (const Pairs&) -> those which are close, as bits
  template <class Pairs, class MayMeet>
  void renew_pairs(const Candidates& candidates, const MayMeet& may_meet) {
    renew(candidates, [&](CandidateRows rows, const auto& take) {
      Pairs pairs{};
      const auto take_pairs = [&] {
        for (std::uint32_t left = may_meet(pairs); left != 0; left &= left - 1) {
          const std::size_t lane = first_lane(left);
          take(pairs.first[lane], pairs.position[lane]);
        }
        pairs.n = 0;
      };
      visit_all(
          candidates, rows, [](Partner) {},
          [&](Row row, std::size_t position) {
            pairs.add(row, candidates.partner(position), position);
            if (pairs.are_full()) take_pairs();
          });
      if (pairs.n > 0) take_pairs();
    });
  }
  void forget() { chunks_ = {}; }

  /// Calls look_at(row, position) for candidates of a chunk of rows, in their order: all, or those that are
  /// close; prefetch(partner) some calls before.
  template <class Prefetch, class LookAt>
  void visit(const Candidates& candidates, CandidateRows rows, CandidateUse use, const Prefetch& prefetch,
             const LookAt& look_at) const {
    if (candidates.partners.empty()) return;
    if (use == CandidateUse::all) return visit_all(candidates, rows, prefetch, look_at);
    const std::vector<Entry>& close = chunks_[rows.begin / rows_per_chunk];
    for (std::size_t i = 0; i < close.size(); ++i) {
      if (i + n_float_lanes < close.size()) prefetch(candidates.partner(close[i + n_float_lanes].position));
      look_at(close[i].row, close[i].position);
    }
  }
  /// Calls look_at(row, position) for those that are close.
  template <class LookAt>
  void visit_close(const LookAt& look_at) const {
    for (const auto& chunk : chunks_) {
      for (const Entry& close : chunk) look_at(close.row, close.position);
    }
  }
  std::size_t size() const {
    std::size_t n = 0;
    for (const auto& chunk : chunks_) n += chunk.size();
    return n;
  }
  std::size_t bytes() const {
    std::size_t bytes = 0;
    for (const auto& chunk : chunks_) bytes += bytes_of(chunk);
    return bytes;
  }

 private:
  template <class Prefetch, class LookAt>
  static void visit_all(const Candidates& candidates, CandidateRows rows, const Prefetch& prefetch,
                        const LookAt& look_at) {
    for (const Row row : rows.indices<Row>()) {
      for (std::size_t k = candidates.first_pair(row); k < candidates.end_pair(row); ++k) {
        const std::size_t later = k + n_float_lanes;
        if (later < candidates.partners.size()) prefetch(candidates.partner(later));
        look_at(row, k);
      }
    }
  }

  std::vector<std::vector<Entry>> chunks_;
};

}  // namespace contactsim
