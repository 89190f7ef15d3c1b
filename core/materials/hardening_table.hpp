// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/materials/hardening_row.hpp"

namespace contactsim {

/// Every hardening that j2_plasticity may name.
std::span<const HardeningRow> hardening_rows();

/// The material that has one hardening alone.
MaterialRow material_of(const HardeningRow& hardening);

/// J2_PLASTICITY, without temperature: the hardening is chosen by name, and factors by the rate.
MaterialRow j2_material();

}  // namespace contactsim
