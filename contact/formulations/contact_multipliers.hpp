// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/pair_node_values.hpp"

namespace contactsim {

/// The augmented Lagrange multipliers of load steps, as depths > 0 [length]: the penalty presses at a depth d
/// as it would by itself at d + m. A multiplier grows by what still penetrates until nothing does, and the
/// penalty is exact for every law of pressure and depth that only grows. They stand at the nodes of one side
/// of a pair, so that they survive when faces meet others. Source: Simo and Laursen, Comput. Struct. 42
/// (1992) 97-116; Wriggers, Computational Contact Mechanics (2006), 6.3.
using ContactMultipliers = PairNodeValues<double>;

}  // namespace contactsim
