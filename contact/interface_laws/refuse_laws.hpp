// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/interface_laws/make_interface_laws.hpp"
#include "contact/surfaces/surface_pairs.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// Adds an error for every friction model that a run cannot act on (see make_pair_laws), and for every pair
/// with an analytic plane whose model holds the sides together: nothing is held to planes.
///   surfaces  that the pairs are of
void refuse_laws(const SurfacePairs& pairs, const SurfaceList& surfaces, const LawScope& scope,
                 Diagnostics& diagnostics);

}  // namespace contactsim
