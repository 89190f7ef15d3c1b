// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/pair_set.hpp"

#include <utility>

#include "core/base/state_archive.hpp"

namespace contactsim {

void PairSet::remap(std::span<const OptionalIndex<std::uint32_t>> first,
                    std::span<const OptionalIndex<std::uint32_t>> second) {
  std::set<std::uint64_t> after;
  for (const std::uint64_t known : keys_) {
    OptionalIndex<std::uint32_t> a = static_cast<std::uint32_t>(known >> 32),
                                 b = static_cast<std::uint32_t>(known);
    if (!first.empty()) a = first[*a];
    if (!second.empty()) b = second[*b];
    if (a && b) after.insert(key(*a, *b));
  }
  keys_ = std::move(after);
}

void PairSet::archive(const std::string& name, StateArchive& saved) { saved.set(name, keys_); }

}  // namespace contactsim
