// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/contact_point.hpp"

namespace contactsim {

/// The gap that a contact point may have at the end of a step, < 0 penetrates: what has penetrated comes out
/// slowly, since all of it at once would throw bodies out; it is the error of some step. What may not part
/// comes back as slowly [length].
///   thickness  of the thinner side [length]
double left_gap(const ContactPoint& point, double thickness);

}  // namespace contactsim
