// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/definition/finite_element_model.hpp"
#include "parser/commands/rows.hpp"

namespace contactsim {

/// BEGIN FINITE ELEMENT MODEL.
const Table<FiniteElementModel>& finite_element_model_table();

}  // namespace contactsim
