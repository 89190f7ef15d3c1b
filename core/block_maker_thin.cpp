// SPDX-License-Identifier: BSD-3-Clause
#include "core/block_maker.hpp"

#include <fmt/format.h>

#include "core/elements/element_table.hpp"
#include "core/line_section.hpp"
#include "core/names.hpp"
#include "core/shell_section.hpp"

namespace contactsim {

std::optional<SolidBlock> BlockMaker::make_shells(std::uint32_t index, const BlockParameters& parameters) {
  const ShellSection* section = find_shell_section(index, parameters);
  const auto properties = make_properties(parameters, nullptr);
  if (section == nullptr || !properties) return std::nullopt;
  const SolidElement* element = find_formulation(index, *section, parameters);
  if (!can_be_plane(properties->law)) {
    add_error(
        parameters.location,
        fmt::format("{}: shells of the model {} are not supported", block_name_, parameters.model->text), "");
    return std::nullopt;
  }
  const DeckLocation& location = section_location_.is_known() ? section_location_ : parameters.location;
  const auto settings = make_shell_settings(*section, parameters, location, diagnostics_);
  const auto thicknesses = find_thicknesses(*section, mesh_, index, location, diagnostics_);
  if (element == nullptr || !settings || !thicknesses) return std::nullopt;
  return make_shell_block(mesh_, index, *element, *properties, *settings, *thicknesses);
}

/// A block without a section has the default one, with the thickness of the mesh.
const ShellSection* BlockMaker::find_shell_section(std::uint32_t index, const BlockParameters& parameters) {
  const SectionDefinition* section = find_section(definition_, parameters);
  section_location_ = section != nullptr ? section->name.location : DeckLocation{};
  if (section == nullptr) return &default_shell_section_;
  const auto* shell = std::get_if<ShellSection>(&section->properties);
  if (shell == nullptr) {
    add_error(section->name.location,
              fmt::format("{} has elements of type {}, but its section '{}' is not a SHELL SECTION",
                          block_name_, topology(mesh_.blocks()[index].shape).name, section->name.text),
              "");
  }
  return shell;
}

const SolidElement* BlockMaker::find_formulation(std::uint32_t index, const ShellSection& section,
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
  const SolidElement* element = find_shell_element(shape.shape, is_alike ? "bt_shell" : wanted);
  if (element != nullptr) return element;
  const std::string known = list_formulations(shape.shape);
  add_error(section.formulation.location.is_known() ? section.formulation.location : parameters.location,
            known.empty()
                ? fmt::format("{} has elements of type {}, which are not supported", block_name_, shape.name)
                : fmt::format("{}: there is no {} with the formulation {}", block_name_, shape.name,
                              section.formulation.text),
            known.empty() ? "shells of three and four nodes are" : fmt::format("it has {}", known));
  return nullptr;
}

std::optional<SolidBlock> BlockMaker::make_lines(std::uint32_t index, const BlockParameters& parameters) {
  const auto properties = make_properties(parameters, nullptr);
  const auto setup =
      make_line_setup(find_section(definition_, parameters), mesh_, index, parameters.location, diagnostics_);
  if (!properties || !setup) return std::nullopt;
  if (setup->element->shape != Shape::sphere && !can_be_fibre(properties->law)) {
    add_error(parameters.location,
              fmt::format("{}: beams and trusses of the model {} are not supported", block_name_,
                          parameters.model->text),
              "");
    return std::nullopt;
  }
  return make_line_block(mesh_, index, *setup->element, *properties, setup->beam, setup->sizes);
}

}  // namespace contactsim
