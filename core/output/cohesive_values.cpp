// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/cohesive_values.hpp"

#include <algorithm>

#include "core/elements/cohesive/cohesive_pairs.hpp"

namespace contactsim {

CohesiveValues::CohesiveValues(const ElementView& element) {
  const ModelBlock& block = element.block();
  if (block.cohesive.area.empty()) return;
  const StateLayout& layout = block.layout;
  const std::size_t n = layout.n_own / cohesive::n_numbers, first = layout.energy() - layout.n_own;
  double stored = 0.0;
  for (std::size_t pair = 0; pair < n; ++pair) {
    std::array<Lanes, cohesive::n_numbers> numbers;
    const auto at = [&](std::size_t number) -> double& { return numbers[number](0); };
    for (std::size_t k = 0; k < cohesive::n_numbers; ++k) {
      const double value = element.context.state.blocks[element.range.block].at(
          layout, element.element(), first + pair * cohesive::n_numbers + k);
      numbers[k].setConstant(value);
    }
    const double share = 1.0 / static_cast<double>(n);
    separation[0] += share * at(cohesive::opening);
    separation[1] += share * at(cohesive::sliding);
    traction[0] += share * at(cohesive::normal);
    traction[1] += share * at(cohesive::tangential);
    damage += share * cohesive::damage(block.cohesive.law, numbers)(0);
    stored +=
        0.5 *
        (at(cohesive::normal) * at(cohesive::opening) + at(cohesive::tangential) * at(cohesive::sliding)) *
        block.cohesive.area[element.element() / n_lanes * n + pair](
            static_cast<Eigen::Index>(element.element() % n_lanes));
  }
  dissipation = element.strain_energy() - stored;
}

}  // namespace contactsim
