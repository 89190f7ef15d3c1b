// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// The elements of every ELEMENT DEATH block of the region, each list ascending. Elements of rigid bodies are
/// left out, with a warning.
/// Errors: wrong names; a block without criterion.
///   model  its blocks learn which of their elements die when they turn inside out
std::vector<std::vector<ElementIndex>> find_death_sets(const ConditionScope& scope, Model& model);

/// Which of Model::blocks an element belongs to. Precondition: it belongs to one.
std::size_t find_model_block(const Model& model, ElementIndex element);

}  // namespace contactsim
