// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace contactsim {

/// Mass or rotational inertia of nodes that no element gives any: next to none, but so that a force or moment
/// on them is noticed.
inline constexpr double minimum_nodal_mass = 1e-300;

}  // namespace contactsim
