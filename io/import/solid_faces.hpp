// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <unordered_map>

#include "core/mesh/mesh.hpp"
#include "io/import/draft_mesh.hpp"

namespace contactsim {

/// Finds the side of a solid by the corners of a face, in any order.
class SolidFaces {
 public:
  /// All faces of the solids of some blocks; elements count through them. A face between two solids is that
  /// of the first.
  explicit SolidFaces(std::span<const ElementBlock> blocks);

  /// The side that has these corners; a triangle repeats its last.
  std::optional<ElementSide> find(const DraftFace& corners) const;

 private:
  struct Hash {
    std::size_t operator()(const DraftFace& key) const;
  };
  std::unordered_map<DraftFace, ElementSide, Hash> sides_;  ///< by sorted corners; looked up only
};

}  // namespace contactsim
