// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/rigid_body.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN RIGID BODY.
const Table<RigidBodyDefinition>& rigid_body_table();

}  // namespace contactsim
