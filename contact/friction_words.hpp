// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "contact/surface_pairs.hpp"
#include "core/definition/friction.hpp"
#include "core/diagnostics.hpp"

namespace contactsim {

/// A law as tables show it: "frictionless", "friction 0.3", "tied", "spring weld".
std::string describe_law(const FrictionLaw& law);

/// Adds an error for every interaction whose law a run cannot act on: all but frictionless, constant
/// friction, tied and glued, and of these the last two with analytic planes, which only push.
///   surfaces  that the pairs are of
void refuse_laws(std::span<const SurfacePair> pairs, std::span<const ContactSurface> surfaces,
                 Diagnostics& diagnostics);

}  // namespace contactsim
