// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_table.hpp"

/// The rows of the element table, one per file.
namespace contactsim {

extern const SolidElement hex8_mean_quadrature;

}  // namespace contactsim
