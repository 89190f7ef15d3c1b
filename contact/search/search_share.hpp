// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/mesh/pair_lists.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// Which parts of a search a rank walks through: every n-th, so that each rank has some of where much is
/// found.
class SearchShare {
 public:
  /// Ranks must outlive it.
  ///   n_boxes  of the tree of rows: a search of few is over before a message comes
  SearchShare(Ranks& ranks, std::size_t n_boxes);

  bool is_shared() const { return is_shared_; }
  bool has(std::size_t part) const {
    return !is_shared_ ||
           part % static_cast<std::size_t>(ranks_.count()) == static_cast<std::size_t>(ranks_.rank());
  }
  /// Sends what this rank's parts have found to all. Returns what all ranks have found.
  std::vector<FoundPairs> gather(std::vector<FoundPairs> own) const;

 private:
  Ranks& ranks_;
  bool is_shared_;
};

}  // namespace contactsim
