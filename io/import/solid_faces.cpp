// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/solid_faces.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// Corners by which a face is known, whatever the order in which they are named.
DraftFace key_of(DraftFace corners) {
  std::sort(corners.begin(), corners.end());
  // Of a triangle one corner is there twice: it goes to the end.
  const auto unique = std::unique(corners.begin(), corners.end());
  std::fill(unique, corners.end(), *(unique - 1));
  return corners;
}

}  // namespace

std::size_t SolidFaces::Hash::operator()(const DraftFace& key) const {
  std::size_t hash = 0;
  for (const NodeIndex node : key) hash = hash * 1000003 + node.value;
  return hash;
}

SolidFaces::SolidFaces(std::span<const ElementBlock> blocks) {
  std::uint32_t element = 0;
  for (const ElementBlock& block : blocks) {
    const Topology& shape = topology(block.shape);
    for (std::uint32_t i = 0; i < block.n_elements; ++i, ++element) {
      if (shape.family != Family::solid) continue;
      const auto nodes = block.element_nodes(i);
      for (std::size_t side = 0; side < shape.sides.size(); ++side) {
        DraftFace corners;
        for (std::size_t c = 0; c < 4; ++c) corners[c] = nodes[shape.sides[side].corners[c]];
        sides_.try_emplace(key_of(corners), ElementSide({element}, static_cast<int>(side) + 1));
      }
    }
  }
}

std::optional<ElementSide> SolidFaces::find(const DraftFace& corners) const {
  const auto found = sides_.find(key_of(corners));
  if (found == sides_.end()) return std::nullopt;
  return found->second;
}

}  // namespace contactsim
