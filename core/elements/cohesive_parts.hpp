// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/lanes.hpp"
#include "core/materials/traction_law.hpp"

namespace contactsim {

/// What cohesive elements have in place of a material, by pairs of opposite nodes, n_pairs to an element.
struct CohesiveParts {
  TractionLaw law;
  std::vector<Lanes> area;       ///< [n_batches x n_pairs] share of the face halfway, in the mesh [length^2]
  std::vector<Lanes> thickness;  ///< [n_batches x n_pairs] from node to node along its normal [length]
  std::vector<Lanes> stable_step;  ///< [n_batches] that the masses of the nodes allow [time]
};

}  // namespace contactsim
