// SPDX-License-Identifier: BSD-3-Clause
#include "contact/loft_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

namespace contactsim {

namespace {

double radius_of_area(double area) { return std::sqrt(area / std::numbers::pi); }

/// What a section says about the body of its elements.
struct SectionSize {
  std::optional<double> thickness, radius;
  double thickness_factor = 1.0, lofting_factor = 0.5;
  std::string attribute;  ///< of the mesh that holds the thickness, "" for the usual one
};

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

bool has_attribute_names(const ElementBlock& block) {
  return std::any_of(block.attribute_names.begin(), block.attribute_names.end(),
                     [](const std::string& name) { return !name.empty(); });
}

/// The attribute of an element by name.
std::optional<double> find_named_attribute(const ElementBlock& block, std::uint32_t element_in_block,
                                           std::string_view name) {
  const auto& names = block.attribute_names;
  const auto named =
      std::find_if(names.begin(), names.end(), [&](const std::string& a) { return fold(a) == fold(name); });
  if (named == names.end()) return std::nullopt;
  const auto column = static_cast<std::size_t>(named - names.begin());
  return block.attributes[element_in_block * names.size() + column];
}

/// The attribute of an element: by its usual name when the block has it, else the first column. All columns
/// of a shell that has one per node count, as their mean. Source: Exodus II attribute order, SAND92-2137.
std::optional<double> find_usual_attribute(const ElementBlock& block, std::uint32_t element_in_block,
                                           std::string_view name) {
  const std::size_t n = block.attribute_names.size();
  if (n == 0) return std::nullopt;
  if (const auto named = find_named_attribute(block, element_in_block, name)) return named;
  const double* values = block.attributes.data() + element_in_block * n;
  const Topology& shape = topology(block.shape);
  const bool is_nodal =
      shape.family == Family::shell && n == static_cast<std::size_t>(block.nodes_per_element);
  if (!is_nodal) return values[0];
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) sum += values[i];
  return sum / static_cast<double>(n);
}

/// Finds the sizes of the elements of one region.
class SizeFinder {
 public:
  SizeFinder(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
             std::span<const ContactSurface> surfaces, Diagnostics& diagnostics)
      : definition_(definition),
        region_(region),
        mesh_(mesh),
        surfaces_(surfaces),
        diagnostics_(diagnostics) {
    for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) sections_.push_back(find_section_size(i));
  }

  LoftSize find(const OwnedElement& owned);

 private:
  std::vector<std::string> names_of(std::uint32_t block, const FiniteElementModel& model) const;
  SectionSize find_section_size(std::uint32_t block) const;
  std::optional<double> find_thickness(const ElementBlock& block, std::uint32_t i,
                                       const SectionSize& section) const;
  std::optional<double> find_radius(const ElementBlock& block, std::uint32_t i, const SectionSize& section,
                                    const ContactSurface& surface) const;
  const SurfaceOptions* find_options(const ContactSurface& surface) const;
  double limit_thickness(double thickness, ElementIndex element, const ContactSurface& surface) const;
  void report(const OwnedElement& owned, std::uint32_t block, std::string_view what,
              std::optional<double> value);

  const SimulationDefinition& definition_;
  const Region& region_;
  const Mesh& mesh_;
  std::span<const ContactSurface> surfaces_;
  Diagnostics& diagnostics_;
  std::vector<SectionSize> sections_;  ///< [n_blocks]
  std::set<std::uint32_t> reported_;   ///< blocks that an error was given for
};

/// All that a deck may call a block: itself and the assemblies that hold it, by mesh name and by alias.
std::vector<std::string> SizeFinder::names_of(std::uint32_t block, const FiniteElementModel& model) const {
  const Entity entity{EntityKind::block, block};
  std::vector<Entity> parts{entity};
  for (std::uint32_t i = 0; i < mesh_.assemblies().size(); ++i) {
    const auto members = mesh_.members(i);
    const bool holds_it = std::find(members.begin(), members.end(), entity) != members.end();
    if (holds_it) parts.push_back({EntityKind::assembly, i});
  }
  std::vector<std::string> names{default_name(EntityKind::block, mesh_.blocks()[block].id)};
  for (const Entity& part : parts) names.push_back(mesh_.name(part));
  for (const MeshAlias& alias : model.aliases) {
    const auto meant = mesh_.find(alias.mesh_name.text);
    if (std::find_first_of(meant.begin(), meant.end(), parts.begin(), parts.end()) != meant.end())
      names.push_back(alias.alias.text);
  }
  return names;
}

SectionSize SizeFinder::find_section_size(std::uint32_t block) const {
  const FiniteElementModel* model = find_finite_element_model(definition_, region_);
  if (model == nullptr) return {};
  const std::vector<std::string> names = names_of(block, *model);
  const BlockParameters* parameters = find_block_parameters(*model, names);
  const SectionDefinition* section =
      parameters ? contactsim::find_section(definition_, *parameters) : nullptr;
  if (section == nullptr) return {};
  return std::visit([](const auto& properties) { return size_of(properties); }, section->properties);
}

/// The last SURFACE OPTIONS block that applies to the surface.
const SurfaceOptions* SizeFinder::find_options(const ContactSurface& surface) const {
  const auto names_it = [&](const std::vector<DeckName>& list) {
    return std::any_of(list.begin(), list.end(),
                       [&](const DeckName& name) { return fold(name.text) == fold(surface.name); });
  };
  const SurfaceOptions* found = nullptr;
  for (const SurfaceOptions& options : region_.contact->surface_options) {
    const bool is_included = options.surfaces.empty() || names_it(options.surfaces);
    if (is_included && !names_it(options.removed_surfaces)) found = &options;
  }
  return found;
}

std::optional<double> SizeFinder::find_thickness(const ElementBlock& block, std::uint32_t i,
                                                 const SectionSize& section) const {
  auto thickness = section.thickness;
  if (!thickness) {
    const bool is_usual = section.attribute.empty() || !has_attribute_names(block);
    thickness = is_usual ? find_usual_attribute(block, i, "thickness")
                         : find_named_attribute(block, i, section.attribute);
  }
  if (thickness) *thickness *= section.thickness_factor;
  return thickness;
}

std::optional<double> SizeFinder::find_radius(const ElementBlock& block, std::uint32_t i,
                                              const SectionSize& section,
                                              const ContactSurface& surface) const {
  const bool is_line = topology(block.shape).family == Family::line;
  const SurfaceOptions* options = is_line ? find_options(surface) : nullptr;
  if (options != nullptr && options->beam_radius) return options->beam_radius;
  if (section.radius) return section.radius;
  auto attribute = find_usual_attribute(block, i, is_line ? "area" : "radius");
  if (attribute && is_line) *attribute = radius_of_area(*attribute);
  return attribute;
}

/// LET_CONTACT_CHOOSE keeps the thickness between two shares of the element's shortest edge.
double SizeFinder::limit_thickness(double thickness, ElementIndex element,
                                   const ContactSurface& surface) const {
  const SurfaceOptions* options = find_options(surface);
  const bool is_limited =
      options != nullptr && options->shell_thickness == SurfaceOptions::ShellThickness::let_contact_choose;
  if (!is_limited) return thickness;
  const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(element)].shape);
  const auto nodes = mesh_.element_nodes(element).first(shape.n_corners);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& x = mesh_.coordinates();
    shortest =
        std::min(shortest, (x.col(nodes[(i + 1) % nodes.size()].value) - x.col(nodes[i].value)).norm());
  }
  const double smallest = options->smallest_shell_thickness * shortest;
  return std::clamp(thickness, smallest, std::max(smallest, options->largest_shell_thickness * shortest));
}

LoftSize SizeFinder::find(const OwnedElement& owned) {
  const std::uint32_t block_index = mesh_.block_of(owned.element);
  const ElementBlock& block = mesh_.blocks()[block_index];
  const std::uint32_t i = owned.element.value - block.first_element.value;
  const SectionSize& section = sections_[block_index];
  const ContactSurface& surface = surfaces_[owned.surface];
  const bool is_shell = topology(block.shape).family == Family::shell;
  const auto value = is_shell ? find_thickness(block, i, section) : find_radius(block, i, section, surface);
  if (!value || !(*value > 0.0) || !std::isfinite(*value)) {
    report(owned, block_index, is_shell ? "thickness" : "radius", value);
    return {};
  }
  if (!is_shell) return {0.0, 0.5, *value};
  return {limit_thickness(*value, owned.element, surface), section.lofting_factor, 0.0};
}

void SizeFinder::report(const OwnedElement& owned, std::uint32_t block, std::string_view what,
                        std::optional<double> value) {
  if (!reported_.insert(block).second) return;
  const std::string name = mesh_.name({EntityKind::block, block});
  const std::string type(topology(mesh_.blocks()[block].shape).name);
  const ContactSurface& surface = surfaces_[owned.surface];
  const std::string& attribute = sections_[block].attribute;
  std::string text = fmt::format("block '{}' ({}) ", name, type);
  if (value) {
    text += fmt::format("cannot be lofted: the {} of element {} is {}", what, mesh_.element_id(owned.element),
                        *value);
  } else if (!attribute.empty()) {
    text += fmt::format("has no attribute '{}' on the mesh, from which its section takes the {}", attribute,
                        what);
  } else {
    text += fmt::format("has no {} to loft it with: neither a section nor an attribute on the mesh", what);
  }
  diagnostics_.add_error(surface.location, std::move(text),
                         fmt::format("it is in contact through surface '{}'", surface.name));
}

}  // namespace

std::vector<LoftSize> find_loft_sizes(const SimulationDefinition& definition, const Region& region,
                                      const Mesh& mesh, std::span<const ContactSurface> surfaces,
                                      std::span<const OwnedElement> elements, Diagnostics& diagnostics) {
  if (elements.empty()) return {};
  SizeFinder finder(definition, region, mesh, surfaces, diagnostics);
  std::vector<LoftSize> sizes;
  for (const OwnedElement& owned : elements) sizes.push_back(finder.find(owned));
  return sizes;
}

}  // namespace contactsim
