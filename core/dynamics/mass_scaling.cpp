// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/mass_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/pluralize.hpp"
#include "core/conditions/entity_elements.hpp"
#include "core/definition/region.hpp"
#include "core/dynamics/scaled_block.hpp"

namespace contactsim {

namespace {

/// What a MASS SCALING block has done.
struct ScalingSum {
  std::size_t n_scaled = 0, n_bounded = 0;
  double added = 0.0;           ///< [mass]
  double largest_factor = 1.0;  ///< [1]
};

void scale_block(const MassScaling& scaling, std::span<const ElementIndex> elements, const Mesh& mesh,
                 ModelBlock& block, ScalingSum& sum) {
  const auto begin = std::ranges::lower_bound(elements, block.first_element);
  const ElementIndex last{block.first_element.value + static_cast<std::uint32_t>(block.n_elements)};
  const auto end = std::ranges::lower_bound(elements, last);
  if (begin == end || block.is_rigid || block.element->step_rule != StepRule::material) return;
  ScaledBlock scaled(mesh, block);
  const double bound = scaling.allowable_mass_increase.value_or(std::numeric_limits<double>::infinity());
  constexpr double rounding = 1e-12;
  for (auto at = begin; at != end; ++at) {
    const std::size_t element = at->value - block.first_element.value;
    const double step = scaled.stable_step(element), wanted = *scaling.target_time_step / step;
    if (!(wanted > 1.0 + rounding)) continue;
    const double factor = std::min(wanted * wanted, std::max(bound, 1.0));
    if (factor < wanted * wanted) ++sum.n_bounded;
    const auto lane = static_cast<Eigen::Index>(element % n_lanes);
    Lanes factors = Lanes::Ones();
    factors(lane) = factor;
    sum.added += (factor - 1.0) * block.mass[element / n_lanes](lane);
    scaled.scale(element / n_lanes, factors);
    ++sum.n_scaled;
    sum.largest_factor = std::max(sum.largest_factor, factor);
  }
}

double mass_of(std::span<const ModelBlock> blocks) {
  double mass = 0.0;
  for (const ModelBlock& block : blocks) {
    for (std::size_t i = 0; i < block.n_elements; ++i)
      mass += block.mass[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes));
  }
  return mass;
}

}  // namespace

void scale_masses(const ConditionScope& scope, std::span<ModelBlock> blocks) {
  for (const MassScaling& scaling : scope.region.mass_scalings) {
    if (!scaling.target_time_step) continue;
    const DeckLocation& place = scaling.name.location;
    const auto elements = find_elements(scaling.set, {"the mass scaling", place}, scope);
    const double before = mass_of(blocks);
    ScalingSum sum;
    for (ModelBlock& block : blocks) scale_block(scaling, elements, scope.mesh, block, sum);
    const auto warn = [&](std::string_view id, std::string text, std::string hint) {
      scope.diagnostics.add_warning(id, place, std::move(text), std::move(hint));
    };
    if (sum.n_scaled == 0) {
      warn("mass-scaling-idle",
           fmt::format("mass scaling has no effect: every element allows a step of {:.5g}",
                       *scaling.target_time_step),
           "");
      continue;
    }
    warn("mass-scaled",
         fmt::format("mass scaling adds {:.5g}, {:.3g} % of all mass: {} up to {:.4g} times as heavy",
                     sum.added, 100.0 * sum.added / before,
                     pluralize(sum.n_scaled, "element is", "elements are"), sum.largest_factor),
         "speeds of waves and inertia are wrong there");
    if (sum.n_bounded > 0) {
      warn("mass-scaling-bounded",
           fmt::format("{} below the target time step by ALLOWABLE MASS INCREASE RATIO",
                       pluralize(sum.n_bounded, "element stays", "elements stay")),
           "the run's step is smaller than the target");
    }
  }
}

}  // namespace contactsim
