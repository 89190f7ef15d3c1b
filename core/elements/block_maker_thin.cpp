// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/block_maker.hpp"

#include <fmt/format.h>

#include "core/base/names.hpp"
#include "core/definition/simulation.hpp"
#include "core/elements/discrete_section.hpp"
#include "core/elements/element_table.hpp"
#include "core/elements/line_section.hpp"
#include "core/elements/shell_section.hpp"

namespace contactsim {

std::optional<ModelBlock> BlockMaker::make_shells(std::uint32_t index, const BlockParameters& parameters) {
  const SectionDefinition* section = find_section(definition_, parameters);
  section_location_ = section != nullptr ? section->name.location : parameters.location;
  const auto* membrane = section != nullptr ? std::get_if<MembraneSection>(&section->properties) : nullptr;
  if (membrane != nullptr) {
    return make_shells(index, parameters, as_shell_section(*membrane),
                       find_formulation(index, *membrane, parameters));
  }
  const ShellSection* shell = find_shell_section(index, section);
  if (shell == nullptr) return std::nullopt;
  return make_shells(index, parameters, *shell, find_formulation(index, *shell, parameters));
}

std::optional<ModelBlock> BlockMaker::make_shells(std::uint32_t index, const BlockParameters& parameters,
                                                  const ShellSection& section,
                                                  const ElementFormulation* element) {
  const auto properties = make_properties(parameters, nullptr);
  if (!properties) return std::nullopt;
  if (properties->law.kind().update_plane == nullptr) {
    add_error(
        parameters.location,
        fmt::format("{}: shells of the model {} are not supported", block_name_, parameters.model->text), "");
    return std::nullopt;
  }
  const auto settings = make_shell_settings(section, parameters, section_location_, diagnostics_);
  const auto thicknesses = find_thicknesses(section, mesh_, index, section_location_, diagnostics_);
  if (element == nullptr || !settings || !thicknesses) return std::nullopt;
  return make_shell_block(mesh_, index, *element, *properties, *settings, *thicknesses);
}

/// A block without a section has the default one, with the thickness of the mesh.
const ShellSection* BlockMaker::find_shell_section(std::uint32_t index, const SectionDefinition* section) {
  if (section == nullptr) return &default_shell_section_;
  const auto* shell = std::get_if<ShellSection>(&section->properties);
  if (shell == nullptr) {
    add_error(
        section->name.location,
        fmt::format("{} has elements of type {}, but its section '{}' is not a SHELL or MEMBRANE SECTION",
                    block_name_, topology(mesh_.blocks()[index].shape).name, section->name.text),
        "");
  }
  return shell;
}

const ElementFormulation* BlockMaker::find_formulation(std::uint32_t index, const ShellSection& section,
                                                       const BlockParameters& parameters) {
  const Topology& shape = topology(mesh_.blocks()[index].shape);
  const std::string wanted = fold(section.formulation.text);
  const bool is_alike = wanted == "bl_shell" || wanted == "kh_shell";
  if (is_alike) {
    diagnostics_.add_warning(
        "shell-formulation", section.formulation.location,
        fmt::format("{}: BT_SHELL stands in for {}", block_name_, section.formulation.text),
        "both have one point of integration in the surface");
  }
  const ElementFormulation* element = find_shell_element(shape.shape, is_alike ? "bt_shell" : wanted);
  if (element != nullptr) return element;
  const std::string known = list_formulations(shape.shape);
  if (known.empty()) {
    refuse_shape(shape, parameters, "shells of three and four nodes are");
    return nullptr;
  }
  add_error(section.formulation.location.is_known() ? section.formulation.location : parameters.location,
            fmt::format("{}: there is no {} with the formulation {}", block_name_, shape.name,
                        section.formulation.text),
            fmt::format("it has {}", known));
  return nullptr;
}

const ElementFormulation* BlockMaker::find_formulation(std::uint32_t index, const MembraneSection& section,
                                                       const BlockParameters& parameters) {
  const Topology& shape = topology(mesh_.blocks()[index].shape);
  const std::string wanted = fold(section.formulation.text);
  const ElementFormulation* element = find_membrane_element(shape.shape);
  if (element == nullptr) {
    refuse_shape(shape, parameters, "membranes of three and four nodes are");
  } else if (wanted == "selective_deviatoric") {
    diagnostics_.add_warning(
        "membrane-formulation", section.formulation.location,
        fmt::format("{}: MEAN_QUADRATURE stands in for {}", block_name_, section.formulation.text),
        "hourglass resistance does what further points would do");
  } else if (wanted != element->formulation) {
    add_error(section.formulation.location,
              fmt::format("{}: there are no membranes with the formulation {}", block_name_,
                          section.formulation.text),
              "there are mean_quadrature and selective_deviatoric");
    return nullptr;
  }
  return element;
}

std::optional<ModelBlock> BlockMaker::make_lines(std::uint32_t index, const BlockParameters& parameters) {
  const SectionDefinition* section = find_section(definition_, parameters);
  if (section != nullptr && is_discrete(*section)) {
    std::optional<ElementProperties> material;
    if (std::holds_alternative<DamperSection>(section->properties))
      material = make_properties(parameters, nullptr);
    return make_discrete(*section, material, {mesh_, index, definition_.functions, diagnostics_});
  }
  const auto properties = make_properties(parameters, nullptr);
  const auto setup = make_line_setup(section, mesh_, index, parameters.location, diagnostics_);
  if (!properties || !setup) return std::nullopt;
  if (setup->element->shape != Shape::sphere && properties->law.kind().update_fibre == nullptr) {
    add_error(parameters.location,
              fmt::format("{}: beams and trusses of the model {} are not supported", block_name_,
                          parameters.model->text),
              "");
    return std::nullopt;
  }
  const bool has_load_at_once = setup->preload.load != 0.0 && setup->preload.period == 0.0;
  if (has_load_at_once && properties->law.kind().fibre_thinning != nullptr) {
    add_error(section->name.location,
              fmt::format("{}: a truss of {} cannot have its INITIAL LOAD from the start", block_name_,
                          parameters.model->text),
              "its stress follows its stretch; give a PERIOD over which the load comes up");
    return std::nullopt;
  }
  ModelBlock block = make_line_block(mesh_, index, *setup->element, *properties, setup->beam, setup->sizes);
  block.preload = setup->preload;
  return block;
}

}  // namespace contactsim
