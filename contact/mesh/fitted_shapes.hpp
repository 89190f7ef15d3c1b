// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// The round shapes that fit the surfaces of pairs with SMOOTHING = AUTO: one for each part of a surface that
/// is connected by edges at which it turns smoothly.
///   mesh  as it is at the start
SmoothingShapes shapes_of_mesh(const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim
