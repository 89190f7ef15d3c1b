// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/section_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/definition/simulation.hpp"
#include "core/mesh/block_names.hpp"

namespace contactsim {

namespace {

template <class Section>
SectionSize size_of_layer(const Section& section) {
  SectionSize size;
  size.thickness = section.thickness;
  size.thickness_factor = section.thickness_scale_factor;
  size.lofting_factor = section.lofting_factor;
  if (section.thickness_mesh_variable) size.attribute = section.thickness_mesh_variable->text;
  return size;
}

SectionSize size_of(const ShellSection& section) { return size_of_layer(section); }
SectionSize size_of(const MembraneSection& section) { return size_of_layer(section); }

SectionSize size_of(const BeamSection& section) {
  SectionSize size;
  if (!section.width && !section.height) return size;
  const double width = section.width.value_or(section.height.value_or(0.0));
  const double height = section.height.value_or(width);
  const bool is_round = section.shape == BeamShape::rod || section.shape == BeamShape::tube;
  size.radius = 0.5 * (is_round ? std::max(width, height) : std::hypot(width, height));
  return size;
}

SectionSize size_of(const TrussSection& section) {
  SectionSize size;
  if (section.area) size.radius = radius_of_area(*section.area);
  return size;
}

SectionSize size_of(const ParticleSection& section) {
  SectionSize size;
  size.radius = section.radius;
  return size;
}

template <class Section>
SectionSize size_of(const Section&) {
  return {};
}

SectionSize find_section_size(const SimulationDefinition& definition, const FiniteElementModel& model,
                              const std::vector<std::string>& block_names) {
  const BlockParameters* parameters = find_block_parameters(model, block_names);
  const SectionDefinition* section = parameters ? find_section(definition, *parameters) : nullptr;
  if (section == nullptr) return {};
  return std::visit([](const auto& properties) { return size_of(properties); }, section->properties);
}

}  // namespace

std::vector<SectionSize> find_section_sizes(const SimulationDefinition& definition, const Region& region,
                                            const Mesh& mesh) {
  std::vector<SectionSize> sizes(mesh.blocks().size());
  const FiniteElementModel* model = find_finite_element_model(definition, region);
  if (model == nullptr) return sizes;
  const auto names = find_block_names(mesh, model->aliases);
  for (std::size_t block = 0; block < sizes.size(); ++block)
    sizes[block] = find_section_size(definition, *model, names[block]);
  return sizes;
}

std::vector<std::uint32_t> find_sizeless_blocks(const SimulationDefinition& definition, const Region& region,
                                                const Mesh& mesh) {
  std::vector<std::uint32_t> blocks;
  const FiniteElementModel* model = find_finite_element_model(definition, region);
  if (model == nullptr) return blocks;
  const auto names = find_block_names(mesh, model->aliases);
  for (std::uint32_t block = 0; block < names.size(); ++block) {
    const BlockParameters* parameters = find_block_parameters(*model, names[block]);
    const SectionDefinition* section = parameters ? find_section(definition, *parameters) : nullptr;
    if (section == nullptr) continue;
    const auto& properties = section->properties;
    const bool is_sizeless = std::holds_alternative<PointMassSection>(properties) ||
                             std::holds_alternative<SpringSection>(properties) ||
                             std::holds_alternative<DamperSection>(properties) ||
                             std::holds_alternative<CohesiveSection>(properties);
    if (is_sizeless) blocks.push_back(block);
  }
  return blocks;
}

double radius_of_area(double area) { return std::sqrt(area / std::numbers::pi); }

}  // namespace contactsim
