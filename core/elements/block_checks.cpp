// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/block_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// Products of a few of these are numbers still: energies are a modulus times a length cubed, wave speeds the
/// root of a modulus over a density. Units of any system differ by less than 1e40 from each other.
constexpr double largest_property = 1e60, smallest_property = 1e-60;
/// Of an element: a property times three lengths.
constexpr double largest_mass = 1e150, smallest_mass = 1e-150;

/// The mass [mass], or infinity where it turns with an inertia that is no number.
double mass_of(const ModelBlock& block, std::size_t element) {
  const auto batch = element / n_lanes;
  const auto lane = static_cast<Eigen::Index>(element % n_lanes);
  const bool turns_finitely = block.inertia.empty() || std::isfinite(block.inertia[batch](lane));
  return turns_finitely ? block.mass[batch](lane) : std::numeric_limits<double>::infinity();
}

/// What is wrong with an element of that mass, and the hint; no text when nothing is.
struct MassProblem {
  std::string text;
  const char* hint = "";
};

MassProblem judge_mass(double mass, bool has_points) {
  if (!std::isfinite(mass))
    return {"too heavy to move: mass or inertia is no finite number",
            "DENSITY, THICKNESS, AREA or the coordinates are too large"};
  if (mass > largest_mass)
    return {fmt::format("too heavy to move: its mass is {:.3g}", mass),
            "DENSITY, THICKNESS, AREA or the coordinates are too large"};
  if (!(mass > 0.0))
    return {"without a positive volume",
            has_points ? "at an integration point; mean quadrature asks less of a shape" : ""};
  if (mass < smallest_mass)
    return {fmt::format("too light to compute with: its mass is {:.3g}", mass),
            "DENSITY, THICKNESS, AREA or the coordinates are too small"};
  return {};
}

void check_masses(const ModelBlock& block, const Mesh& mesh, const DeckLocation& location,
                  Diagnostics& diagnostics) {
  std::size_t n_bad = 0, first = 0;
  for (std::size_t element = 0; element < block.n_elements; ++element) {
    const double mass = mass_of(block, element);
    if (mass >= smallest_mass && mass <= largest_mass) continue;
    if (n_bad++ == 0) first = element;
  }
  if (n_bad == 0) return;
  const auto id = mesh.element_id({block.first_element.value + static_cast<std::uint32_t>(first)});
  const MassProblem problem = judge_mass(mass_of(block, first), block.element->n_points > 1);
  diagnostics.add_error(
      location,
      fmt::format("{}: element {}{} {}", mesh.name({EntityKind::block, block.mesh_block}), id,
                  n_bad > 1 ? fmt::format(" and {} more are", n_bad - 1) : " is", problem.text),
      problem.hint);
}

void check_properties(const ModelBlock& block, const Mesh& mesh, const DeckLocation& location,
                      Diagnostics& diagnostics) {
  struct Property {
    const char* name;
    double value;
  };
  const ElasticModuli& moduli = block.properties.law.moduli();
  for (const auto& [name, value] :
       {Property{"density", block.properties.density}, Property{"bulk modulus", moduli.bulk},
        Property{"shear modulus", moduli.shear}}) {
    if (value >= smallest_property && value <= largest_property) continue;
    diagnostics.add_error(location,
                          fmt::format("{}: a {} of {:.3g} is too {} to compute with",
                                      mesh.name({EntityKind::block, block.mesh_block}), name, value,
                                      value > largest_property ? "large" : "small"),
                          fmt::format("{:g} to {:g} is possible", smallest_property, largest_property));
  }
}

}  // namespace

void check_block(const ModelBlock& block, const Mesh& mesh, const DeckLocation& location,
                 Diagnostics& diagnostics) {
  const std::size_t n_before = diagnostics.error_count();
  check_properties(block, mesh, location, diagnostics);
  if (diagnostics.error_count() == n_before) check_masses(block, mesh, location, diagnostics);
}

}  // namespace contactsim
