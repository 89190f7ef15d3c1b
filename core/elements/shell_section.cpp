// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/shell_section.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "core/mesh/element_attributes.hpp"

namespace contactsim {

namespace {

std::optional<double> find_thickness(const ShellSection& section, const ElementBlock& block,
                                     std::uint32_t element) {
  if (section.thickness) return section.thickness;
  const auto& variable = section.thickness_mesh_variable;
  return variable && has_attribute_names(block) ? find_named_attribute(block, element, variable->text)
                                                : find_usual_attribute(block, element, "thickness");
}

std::string describe_missing(const ShellSection& section) {
  if (!section.thickness_mesh_variable)
    return "has no thickness: neither a section nor an attribute on the mesh";
  return fmt::format("has no attribute '{}' on the mesh, from which its section takes the thickness",
                     section.thickness_mesh_variable->text);
}

void warn_of_no_effect(const BlockParameters& parameters, Diagnostics& diagnostics) {
  if (parameters.hourglass_viscosity > 0.0) {
    diagnostics.add_warning("shell-hourglass-viscosity", parameters.location,
                            "HOURGLASS VISCOSITY has no effect on shells");
  }
}

}  // namespace

ShellSection as_shell_section(const MembraneSection& section) {
  ShellSection shell;
  shell.thickness = section.thickness;
  shell.thickness_scale_factor = section.thickness_scale_factor;
  shell.thickness_mesh_variable = section.thickness_mesh_variable;
  shell.integration_rule.text = "gauss";
  shell.n_integration_points = 1;
  return shell;
}

std::optional<ShellSettings> make_shell_settings(const ShellSection& section,
                                                 const BlockParameters& parameters,
                                                 const DeckLocation& location, Diagnostics& diagnostics) {
  warn_of_no_effect(parameters, diagnostics);
  ShellSettings settings;
  settings.layers = make_layers(section.integration_rule.text, section.n_integration_points);
  settings.offset = section.lofting_factor - 0.5;
  settings.membrane_hourglass = settings.bending_hourglass = settings.shear_hourglass =
      parameters.hourglass_stiffness;
  settings.drilling = section.drilling_stiffness_factor;
  if (!settings.layers.empty()) return settings;
  const DeckName& rule = section.integration_rule;
  diagnostics.add_error(
      rule.location.is_known() ? rule.location : location,
      fmt::format("there is no integration rule '{}' of {} points", rule.text, section.n_integration_points),
      fmt::format("there are {}; lobatto has 2 points or more, simpsons an odd number from 3",
                  fmt::join(layer_rules(), ", ")));
  return std::nullopt;
}

std::optional<std::vector<double>> find_thicknesses(const ShellSection& section, const Mesh& mesh,
                                                    std::uint32_t block, const DeckLocation& location,
                                                    Diagnostics& diagnostics) {
  const ElementBlock& source = mesh.blocks()[block];
  const std::string name = mesh.name({EntityKind::block, block});
  std::vector<double> thicknesses;
  for (std::uint32_t element = 0; element < source.n_elements; ++element) {
    const auto found = find_thickness(section, source, element);
    if (!found) {
      diagnostics.add_error(location, fmt::format("{} {}", name, describe_missing(section)));
      return std::nullopt;
    }
    thicknesses.push_back(*found * section.thickness_scale_factor);
    if (thicknesses.back() > 0.0 && std::isfinite(thicknesses.back())) continue;
    diagnostics.add_error(
        location, fmt::format("{}: the thickness of element {} is {}", name,
                              mesh.element_id({source.first_element.value + element}), thicknesses.back()));
    return std::nullopt;
  }
  return thicknesses;
}

}  // namespace contactsim
