// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// How much of a surface node's own area lies before another surface, where the node projects inside a face
/// of it [1]. The area is that of the parts next to the node of its faces that are turned towards the face's
/// normal; a part counts when its centre, seen along that normal, is inside the borders of the surface. 1 of
/// nodes without faces.
double covered_share(const ContactKinematics& kinematics, const SurfaceNode& node, FaceIndex face);

}  // namespace contactsim
