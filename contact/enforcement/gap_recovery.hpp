// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace contactsim {

/// The gap that a contact point may have at the end of a step, < 0 penetrates: what has penetrated comes out
/// slowly, since all of it at once would throw bodies out; it is the error of some step. What may not part
/// comes back as slowly [length].
///   gap        now [length]
///   pulls      it may not part
///   thickness  of the thinner side [length]
double left_gap(double gap, bool pulls, double thickness);

}  // namespace contactsim
