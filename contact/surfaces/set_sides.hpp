// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "contact/surfaces/sort_once.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// One side of one side set.
struct SetSide {
  ElementSide side;
  std::uint32_t set = 0;
  auto operator<=>(const SetSide&) const = default;
};

/// The sides of some side sets, to be looked up by element.
class SetSides {
 public:
  /// sets  positions of side sets in the mesh, each once
  SetSides(const Mesh& mesh, std::span<const std::uint32_t> sets) {
    for (const std::uint32_t set : sets) {
      for (const ElementSide side : mesh.side_sets()[set].sides) sides_.push_back({side, set});
    }
    sort_once(sides_);
  }

  /// All, those of one element, and those of one side: ascending.
  std::span<const SetSide> all() const { return sides_; }
  std::span<const SetSide> of(ElementIndex element) const {
    return find(element, [](const SetSide& one) { return one.side.element(); });
  }
  std::span<const SetSide> of(ElementSide side) const { return find(side, &SetSide::side); }

 private:
  /// Those with a key: few, so that the last is near the first.
  template <class Key, class KeyOf>
  std::span<const SetSide> find(Key key, const KeyOf& key_of) const {
    const auto first = std::ranges::lower_bound(sides_, key, {}, key_of);
    const auto last = std::find_if(first, sides_.end(),
                                   [&](const SetSide& one) { return std::invoke(key_of, one) != key; });
    return {first, last};
  }

  std::vector<SetSide> sides_;
};

/// The sides themselves, each once.
inline std::vector<ElementSide> distinct_sides(std::span<const SetSide> set_sides) {
  std::vector<ElementSide> sides;
  for (const SetSide& one : set_sides) {
    if (sides.empty() || sides.back() != one.side) sides.push_back(one.side);
  }
  return sides;
}

}  // namespace contactsim
