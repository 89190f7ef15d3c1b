// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/materials/material_row.hpp"

namespace contactsim {

/// A hardening of the plastic law: by its word of j2_plasticity, and as models of their own.
struct HardeningRow {
  std::string word;                   ///< of HARDENING MODEL
  std::vector<std::string> models;    ///< as MaterialRow::names; of one that j2_plasticity alone has, none
  std::string help;                   ///< one line, of the models
  std::vector<Parameter> parameters;  ///< besides the elastic constants and the yield stress
  const LawKind* law = nullptr;
  MakeMaterialLaw make = nullptr;
};

/// YIELD STRESS, which all of them have.
inline Parameter yield_stress() {
  return parameter::positive("yield stress", "Initial yield stress [force/length^2]").required();
}

/// BETA, of those with a back stress.
inline Parameter isotropic_share() {
  return parameter::real("beta", "Share of isotropic hardening, 0 to 1 [1]").otherwise(1.0);
}

}  // namespace contactsim
