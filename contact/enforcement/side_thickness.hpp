// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// The thickness of the thinner side of a contact point, of the only one that meets a plane [length].
double thinner_side(const ContactMesh& contact_mesh, const ContactPoint& point);

}  // namespace contactsim
