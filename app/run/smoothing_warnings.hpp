// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_force.hpp"
#include "core/base/diagnostics.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// Warns of pairs whose smoothing does nothing, because they only tie, no face goes round the shape or the
/// law acts across gaps of faces ("smoothing-without-effect"), and of shapes that faces lean on
/// ("smoothing-askew").
void warn_of_smoothings(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                        Diagnostics& warnings);

/// Warns of smoothed surfaces whose edges have stretched or shrunk by more than a tenth
/// ("smoothing-strained"): their round shapes are those of the start.
void warn_of_strain(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                    const State& state, Diagnostics& warnings);

}  // namespace contactsim
