// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/material.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN MATERIAL, also PROPERTY SPECIFICATION FOR MATERIAL.
const Table<MaterialDefinition>& material_table();

/// What is wrong with a model that a block uses: elastic constants other than two, a parameter missing
/// that others call for.
void check_used_model(const MaterialDefinition& material, const MaterialModel& model,
                      Diagnostics& diagnostics);

/// What is wrong with a material that a block uses: no density.
void check_used_material(const MaterialDefinition& material, Diagnostics& diagnostics);

}  // namespace contactsim
