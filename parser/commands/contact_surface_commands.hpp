// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/contact.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// The commands of a contact definition that make or restrict surfaces.
std::vector<Row<ContactDefinition>> contact_surface_rows();

/// BEGIN ANALYTIC OBJECT.
const Table<AnalyticPlane>& analytic_object_table();

}  // namespace contactsim
