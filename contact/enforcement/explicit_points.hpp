// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// The contact points of load steps as explicit contact of the same pairs has them: those of NODE_FACE by
/// nodes of both sides, each with the pressure around it against every face that it has met, for half of the
/// force.
std::vector<ContactPoint> explicit_points_of(std::span<const ContactPoint> of_load_steps,
                                             const SurfacePairs& pairs, const ContactMesh& contact_mesh);

}  // namespace contactsim
