// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "contact/formulations/contact_step_context.hpp"

/// The gaps between the sides of pairs before the first step, on the mesh as it is.
namespace contactsim {

/// The gap of two faces where they lie before each other; nothing when contact would not take them: too deep,
/// or deeper than wide as the sides of two bodies that overlap at an edge.
/// Returns a gap of the first face.
std::optional<StartGap> find_start_gap(const ContactKinematics& kinematics, const SurfacePair& pair,
                                       FaceIndex first, FaceIndex second);

/// The gap of a surface node to the nearest face, either way, among those that it projects inside and looks
/// at with a face of its own; nothing without one. The gap of a sphere counts from its surface.
///   faces  that may be near
std::optional<StartGap> find_start_gap(const ContactKinematics& kinematics, const PairRules& rules,
                                       SurfaceNodeIndex row, IndexView<FaceIndex> faces);

}  // namespace contactsim
