// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_kinematics.hpp"

namespace contactsim {

/// The velocity of the first side of a contact point against the second, in the step before or in the coming
/// one as the forces so far give it [length/time].
Eigen::Vector3d relative_velocity(const ContactKinematics& kinematics, const ContactPoint& point,
                                  bool is_before);

}  // namespace contactsim
