// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>

#include "core/base/index.hpp"

namespace contactsim {

/// Position of a node in the mesh, from 0. Not the user's node id (see Mesh::node_id).
using NodeIndex = Index<struct MeshNodeKind>;

/// Position of an element in the mesh, from 0, counted through the blocks in file order.
using ElementIndex = Index<struct MeshElementKind>;

/// One side of one element, by element position and Exodus side number (from 1).
/// Ordered by element, then side. Packed into 32 bits because skins hold millions of them.
class ElementSide {
 public:
  ElementSide() = default;
  /// Preconditions: element.value < 2^29, 1 <= side <= 8.
  constexpr ElementSide(ElementIndex element, int side)
      : packed_((element.value << 3) | static_cast<std::uint32_t>(side - 1)) {}

  constexpr ElementIndex element() const { return {packed_ >> 3}; }
  constexpr int side() const { return static_cast<int>(packed_ & 7u) + 1; }
  auto operator<=>(const ElementSide&) const = default;

 private:
  std::uint32_t packed_ = 0;
};

/// Largest number of elements that ElementSide can address.
inline constexpr std::uint32_t max_elements = 1u << 29;

}  // namespace contactsim
