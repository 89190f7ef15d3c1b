// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/block_maker.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/base/names.hpp"
#include "core/definition/finite_element_model.hpp"
#include "core/definition/simulation.hpp"
#include "core/elements/block_checks.hpp"
#include "core/elements/cohesive_section.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/linear_advice.hpp"
#include "core/elements/material_directions.hpp"
#include "core/materials/material_table.hpp"
#include "core/materials/traction_law_table.hpp"

namespace contactsim {

void BlockMaker::add(std::uint32_t index, std::span<const std::string> names,
                     std::vector<ModelBlock>& blocks) {
  const BlockParameters* parameters = find_block_parameters(model_, names);
  block_name_ = mesh_.name({EntityKind::block, index});
  block_id_ = mesh_.blocks()[index].id;
  if (parameters == nullptr) {
    add_error(model_.name.location,
              fmt::format("{} has no PARAMETERS FOR BLOCK in '{}'", block_name_, model_.name.text),
              "INCLUDE ALL BLOCKS in one of them takes all that no other names");
    return;
  }
  auto block = make(topology(mesh_.blocks()[index].shape).family, index, *parameters);
  if (!block) return;
  if (block->element->has_material()) check_block(*block, mesh_, parameters->location, diagnostics_);
  const SectionDefinition* section = find_section(definition_, *parameters);
  if (block->properties.law.kind().n_vectors > 0 && !give_directions(*parameters, section, *block)) return;
  block->is_rigid = section != nullptr && section->rigid_body;
  block->material = block->element->has_material() || parameters->model
                        ? fmt::format("{} ({})", parameters->material->text, parameters->model->text)
                        : "none";
  blocks.push_back(std::move(*block));
}

std::optional<ModelBlock> BlockMaker::make(Family family, std::uint32_t index,
                                           const BlockParameters& parameters) {
  if (family == Family::shell) return make_shells(index, parameters);
  if (family == Family::cohesive) return make_cohesive(index, parameters);
  const bool is_thin = family == Family::line || family == Family::particle;
  return is_thin ? make_lines(index, parameters) : make_solids(index, parameters);
}

BlockMaker::BlockMaterial BlockMaker::find_material(const BlockParameters& parameters) {
  if (!parameters.material || !parameters.model) {
    add_error(parameters.location,
              fmt::format("{} has no {}", block_name_, parameters.material ? "MODEL" : "MATERIAL"), "");
    return {};
  }
  const MaterialDefinition* material = find_by_name(definition_.materials, parameters.material->text);
  return {material, material ? find_model(*material, parameters.model->text) : nullptr};
}

std::optional<ModelBlock> BlockMaker::make_cohesive(std::uint32_t index, const BlockParameters& parameters) {
  const auto [material, model] = find_material(parameters);
  if (model == nullptr) return std::nullopt;
  const SectionDefinition& section = *find_section(definition_, parameters);
  const auto law = make_traction_law(*model, diagnostics_);
  if (!law) return std::nullopt;
  const double density = std::isnan(material->density) ? 0.0 : material->density;
  auto block = make_cohesive_block(mesh_, index, *law, density, section.name.location, diagnostics_);
  const auto n_points = std::get<CohesiveSection>(section.properties).n_integration_points;
  const auto n_pairs = static_cast<std::int64_t>(topology(mesh_.blocks()[index].shape).n_nodes / 2);
  if (n_points != n_pairs && n_points != CohesiveSection{}.n_integration_points) {
    diagnostics_.add_warning(
        "cohesive-points", section.name.location,
        fmt::format("{}: all {} pairs of opposite nodes carry tractions", block_name_, n_pairs),
        "NUMBER OF INTEGRATION POINTS has no effect");
  }
  return block;
}

std::optional<ModelBlock> BlockMaker::make_solids(std::uint32_t index, const BlockParameters& parameters) {
  const SolidSection* section = find_solid_section(index, parameters);
  const ElementFormulation* element =
      section ? find_formulation(topology(mesh_.blocks()[index].shape), *section, parameters) : nullptr;
  const auto properties = make_properties(parameters, section);
  if (element == nullptr || !properties) return std::nullopt;
  if (element->shape == Shape::tet10 && parameters.hourglass_viscosity > 0.0) {
    diagnostics_.add_warning("hourglass-viscosity", parameters.location,
                             fmt::format("{}: ten-node tetrahedra have no hourglass viscosity", block_name_),
                             "HOURGLASS VISCOSITY has no effect on them");
  }
  return make_solid_block(mesh_, index, *element, *properties);
}

void BlockMaker::add_error(const DeckLocation& location, std::string text, std::string hint) {
  diagnostics_.add_error(location, std::move(text), std::move(hint));
}

const SolidSection* BlockMaker::find_solid_section(std::uint32_t index, const BlockParameters& parameters) {
  const Topology& shape = topology(mesh_.blocks()[index].shape);
  const SectionDefinition* section = find_section(definition_, parameters);
  const SolidSection* solid = &default_section_;
  if (section != nullptr) solid = std::get_if<SolidSection>(&section->properties);
  if (section != nullptr && solid == nullptr) solid = take_lagrange_section(shape, *section);
  if (shape.family != Family::solid) {
    add_error(parameters.location,
              fmt::format("{} has elements of type {}, which cannot move", block_name_, shape.name),
              "--check resolves the surfaces of all of them");
    return nullptr;
  }
  if (solid == nullptr && std::holds_alternative<CohesiveSection>(section->properties)) {
    add_error(section->name.location,
              fmt::format("{} has elements of type {}, which cannot be cohesive", block_name_, shape.name),
              "HEX8 and WEDGE6 can");
    return nullptr;
  }
  if (solid == nullptr) {
    add_error(section->name.location,
              fmt::format("{} has elements of type {}, but its section '{}' is not a SOLID SECTION",
                          block_name_, shape.name, section->name.text),
              "");
    return nullptr;
  }
  check_options(*solid);
  return solid;
}

/// A TOTAL LAGRANGE SECTION of ten-node tetrahedra as the solid section that means the same element; null of
/// any other.
const SolidSection* BlockMaker::take_lagrange_section(const Topology& shape,
                                                      const SectionDefinition& section) {
  const auto* lagrange = std::get_if<TotalLagrangeSection>(&section.properties);
  if (lagrange == nullptr || shape.shape != Shape::tet10) return nullptr;
  diagnostics_.add_warning(
      "total-lagrange", section.name.location,
      fmt::format("{}: strain is taken step by step, not from the undeformed element", block_name_),
      "the dilatation is the mean one of the element; VOLUME AVERAGE J and VEM EXPONENT have no effect");
  lagrange_section_.formulation = lagrange->formulation;
  return &lagrange_section_;
}

/// Everything but the formulation that a SOLID SECTION may ask for.
void BlockMaker::check_options(const SolidSection& solid) {
  const DeckName& strain = solid.strain_incrementation;
  // Hughes and Winget's increment is objective and taken in the middle of the step: it is both.
  if (fold(strain.text) != "midpoint_increment" && fold(strain.text) != "strongly_objective") {
    add_error(strain.location, fmt::format("there is no strain incrementation '{}'", strain.text),
              "there are midpoint_increment and strongly_objective");
  }
  if (solid.is_hourglass_total || solid.is_hourglass_rotation_scaled) {
    diagnostics_.add_warning(
        "hourglass-incremental", strain.location,
        fmt::format("{}: hourglass forces are incremental and turn with the material", block_name_),
        "HOURGLASS FORMULATION and HOURGLASS ROTATION have no effect");
  }
}

const ElementFormulation* BlockMaker::find_formulation(const Topology& shape, const SolidSection& solid,
                                                       const BlockParameters& parameters) {
  const ElementFormulation* element = find_solid_element(shape.shape, solid.formulation.text);
  const bool says_nothing =
      !solid.formulation.location.is_known() && solid.formulation.text == SolidSection{}.formulation.text;
  if (element == nullptr && says_nothing) element = default_solid_element(shape.shape);
  if (element != nullptr) return element;
  const bool is_known = !list_formulations(shape.shape).empty();
  const DeckLocation& location =
      is_known && solid.formulation.location.is_known() ? solid.formulation.location : parameters.location;
  if (!is_known) {
    refuse_shape(shape, parameters, "linear hexahedra, tetrahedra, wedges and pyramids are");
  } else {
    add_error(location,
              fmt::format("{}: there is no {} with the formulation {}", block_name_, shape.name,
                          solid.formulation.text),
              fmt::format("it has {}", list_formulations(shape.shape)));
  }
  return nullptr;
}

void BlockMaker::refuse_shape(const Topology& shape, const BlockParameters& parameters, const char* known) {
  const std::string advice = linear_advice(shape.shape, block_id_);
  add_error(parameters.location,
            fmt::format("{} (block {}) has elements of type {}, which are not supported", block_name_,
                        block_id_, shape.name),
            advice.empty() ? known : advice);
}

std::optional<ElementProperties> BlockMaker::make_properties(const BlockParameters& parameters,
                                                             const SolidSection* section) {
  const auto [material, model] = find_material(parameters);
  if (model == nullptr) return std::nullopt;
  if (parameters.effective_moduli_model != EffectiveModuliModel::elastic) {
    diagnostics_.add_warning("effective-moduli", parameters.location,
                             fmt::format("{}: EFFECTIVE MODULI MODEL has no effect", block_name_),
                             "viscosity and hourglass resistance follow the elastic moduli");
  }
  const auto law = make_material_law(*model, definition_.functions, diagnostics_);
  if (!law) return std::nullopt;
  return ElementProperties{*law,
                           material->density,
                           parameters.hourglass_stiffness,
                           parameters.hourglass_viscosity,
                           parameters.linear_bulk_viscosity,
                           parameters.quadratic_bulk_viscosity,
                           section != nullptr ? section->deviatoric_parameter.value_or(1.0) : 1.0};
}

/// The ORIENTATION of a shell section goes before the system of the material. False when an error was added.
bool BlockMaker::give_directions(const BlockParameters& parameters, const SectionDefinition* section,
                                 ModelBlock& block) {
  const MaterialDefinition* material = find_by_name(definition_.materials, parameters.material->text);
  const ParameterValues& values = find_model(*material, parameters.model->text)->values;
  const auto* shell = section != nullptr ? std::get_if<ShellSection>(&section->properties) : nullptr;
  const auto name =
      shell != nullptr && shell->orientation ? shell->orientation : values.find_name("coordinate system");
  const auto turn = [&values](const std::string& before) -> AxisRotation {
    return {values.count(before + "direction for rotation") + 1, values.real(before + "alpha")};
  };
  MaterialDirections directions{{}, turn(""), turn("second ")};
  if (name) {
    const auto system = find_coordinate_system(*name, definition_, diagnostics_);
    if (!system) return false;
    directions.system = *system;
  }
  const auto lost = set_directions(directions, mesh_, block);
  if (!lost) return true;
  const auto id = mesh_.element_id({block.first_element.value + static_cast<std::uint32_t>(*lost)});
  add_error(name ? name->location : parameters.location,
            fmt::format("{}: direction 1 of the material is the normal of the shell {}", block_name_, id),
            "turn the coordinate system, or the material in it by ALPHA");
  return false;
}

}  // namespace contactsim
