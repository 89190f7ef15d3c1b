// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// The shapes that a SURFACE SMOOTHING block gives to surfaces, by name or ALL; of several regions that name
/// a surface the last one counts.
///   definition   of the points, axes and directions that it names
///   diagnostics  gets errors for those that are not there, and for axes through one point
SmoothingShapes shapes_of_deck(const SurfaceSmoothing& smoothing, const ContactModel& model,
                               const SimulationDefinition& definition, Diagnostics& diagnostics);

}  // namespace contactsim
