// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/face_groups.hpp"

namespace contactsim {

/// What changes in a skin (core/mesh/skin.hpp) when elements die.
struct SkinChange {
  std::vector<ElementSide> exposed;      ///< faces of living solids that become exterior, ascending
  std::vector<ElementSide> removed;      ///< exterior faces of the dead, ascending
  std::vector<std::int32_t> in_between;  ///< [n_blocks] change of Skin::in_between
};

/// The skin of `present` without the dead, less the skin of `present`. Nothing that lives can lose an
/// exterior face.
///   present  [n_elements] 0 or 1, the dead still as they were
///   dead     ascending; those that are not present change nothing
/// Time proportional to the number of the dead.
SkinChange find_skin_change(const FaceGroups& faces, std::span<const std::uint8_t> present,
                            std::span<const ElementIndex> dead);

}  // namespace contactsim
