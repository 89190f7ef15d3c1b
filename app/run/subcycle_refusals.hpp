// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_mesh.hpp"
#include "core/conditions/condition_scope.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// Refuses contact at the nodes of subcycled elements, which move in parts of a step while contact acts once
/// in it, and element death where surfaces may come to have such nodes.
void refuse_subcycled_contact(const ConditionScope& scope, const Model& model, const ContactMesh& contact,
                              Diagnostics& diagnostics);

}  // namespace contactsim
