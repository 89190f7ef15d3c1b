// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/surfaces/request_parts.hpp"
#include "core/definition/contact_surfaces.hpp"

namespace contactsim {

/// What BEGIN CONTACT SURFACE asks for: blocks less the removed ones, side sets, assemblies, single lofted
/// elements, subsets. Mistakes are errors in the diagnostics of `parts`.
/// Source: Sierra/SM 5.22, 8.4.3 and 8.4.4.1.
SurfaceRequest make_block_form_request(const ContactSurfaceBlock& block, RequestParts& parts);

}  // namespace contactsim
