// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/material_models.hpp"
#include "parser/commands/row_lists.hpp"

/// What PARAMETERS FOR MODEL blocks hold.
namespace contactsim {

/// The elastic constants, which all models have.
std::vector<Row<ElasticConstants>> elastic_rows();

/// A model's own rows after those of its elastic constants.
template <class Model>
std::vector<Row<Model>> with_elastic_rows(std::vector<Row<Model>> own_rows) {
  return joined({lift_all(elastic_rows(), &Model::elastic), std::move(own_rows)});
}

/// The rows of each model.
const Table<ElasticPlasticModel>& elastic_plastic_table();
const Table<PowerHardeningModel>& power_hardening_table();
const Table<JohnsonCookModel>& johnson_cook_table();
const Table<MultilinearModel>& multilinear_table();
const Table<TearingModel>& tearing_table();
const Table<J2Model>& j2_table();

}  // namespace contactsim
