// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft_sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "contact/lofting/section_sizes.hpp"
#include "contact/surfaces/surface_options.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/element_attributes.hpp"

namespace contactsim {

namespace {

/// What the contact definition says about the lofts of one surface.
struct LoftOptions {
  std::optional<double> beam_radius;
  const SurfaceOptions* of_shells = nullptr;
};

/// Of the blocks that are for a surface a later one overrides what earlier ones give.
IndexedVector<SurfaceIndex, LoftOptions> find_loft_options(const std::vector<SurfaceOptions>& blocks,
                                                           const SurfaceList& surfaces) {
  IndexedVector<SurfaceIndex, LoftOptions> found(surfaces.size());
  visit_surface_options(blocks, surfaces, [&](SurfaceIndex i, const SurfaceOptions& options) {
    if (options.beam_radius) found[i].beam_radius = options.beam_radius;
    found[i].of_shells = &options;
  });
  return found;
}

/// A number that deck or mesh give for the body of an element; absent when they give none.
struct Measure {
  enum class Quantity : std::uint8_t { thickness, radius, area };

  Quantity quantity = Quantity::thickness;
  std::optional<double> value;

  bool is_usable() const { return value && *value > 0.0 && std::isfinite(*value); }
};

std::string_view to_string(Measure::Quantity quantity) {
  switch (quantity) {
    case Measure::Quantity::thickness:
      return "thickness";
    case Measure::Quantity::radius:
      return "radius";
    case Measure::Quantity::area:
      return "area";
  }
  return "";
}

Measure find_thickness(const ElementBlock& block, std::uint32_t i, const SectionSize& section) {
  auto thickness = section.thickness;
  if (!thickness) {
    const bool is_usual = section.attribute.empty() || !has_attribute_names(block);
    thickness = is_usual ? find_usual_attribute(block, i, "thickness")
                         : find_named_attribute(block, i, section.attribute);
  }
  if (thickness) *thickness *= section.thickness_factor;
  return {Measure::Quantity::thickness, thickness};
}

Measure find_radius_or_area(const ElementBlock& block, std::uint32_t i, const SectionSize& section,
                            const LoftOptions& options) {
  using enum Measure::Quantity;
  const bool is_line = topology(block.shape).family == Family::line;
  if (is_line && options.beam_radius) return {radius, options.beam_radius};
  if (section.radius) return {radius, section.radius};
  const auto attribute = find_usual_attribute(block, i, is_line ? "area" : "radius");
  return {is_line && attribute ? area : radius, attribute};
}

/// LET_CONTACT_CHOOSE keeps the thickness between two shares of the element's shortest edge.
double limit_thickness(double thickness, const Mesh& mesh, ElementIndex element,
                       const SurfaceOptions* options) {
  const bool is_limited =
      options != nullptr && options->shell_thickness == SurfaceOptions::ShellThickness::let_contact_choose;
  if (!is_limited) return thickness;
  const Topology& shape = topology(mesh.blocks()[mesh.block_of(element)].shape);
  const auto nodes = mesh.element_nodes(element).first(shape.n_corners);
  const auto& x = mesh.coordinates();
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double length = (x.col(nodes[(i + 1) % nodes.size()].value) - x.col(nodes[i].value)).norm();
    if (length > 0.0) shortest = std::min(shortest, length);  // degenerate shells have edges without length
  }
  if (std::isinf(shortest)) return thickness;
  const double smallest = options->smallest_shell_thickness * shortest;
  return std::clamp(thickness, smallest, std::max(smallest, options->largest_shell_thickness * shortest));
}

/// Finds the sizes of the elements of one region.
class SizeFinder {
 public:
  SizeFinder(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
             const SurfaceList& surfaces, Diagnostics& diagnostics)
      : mesh_(mesh),
        surfaces_(surfaces),
        diagnostics_(diagnostics),
        options_(find_loft_options(region.contact->surface_options, surfaces)),
        sections_(find_section_sizes(definition, region, mesh)) {}

  LoftSize find(const OwnedElement& owned);

 private:
  void report(const OwnedElement& owned, std::uint32_t block, const Measure& measure);

  const Mesh& mesh_;
  const SurfaceList& surfaces_;
  Diagnostics& diagnostics_;
  IndexedVector<SurfaceIndex, LoftOptions> options_;
  std::vector<SectionSize> sections_;  ///< [n_blocks]
  std::set<std::uint32_t> reported_;   ///< blocks that an error was given for
};

LoftSize SizeFinder::find(const OwnedElement& owned) {
  const std::uint32_t block_index = mesh_.block_of(owned.element);
  const ElementBlock& block = mesh_.blocks()[block_index];
  const std::uint32_t i = owned.element.value - block.first_element.value;
  const SectionSize& section = sections_[block_index];
  const LoftOptions& options = options_[owned.surface];
  const bool is_shell = topology(block.shape).family == Family::shell;
  const Measure measure =
      is_shell ? find_thickness(block, i, section) : find_radius_or_area(block, i, section, options);
  LoftSize size;
  if (!measure.is_usable()) {
    report(owned, block_index, measure);
  } else if (is_shell) {
    size.thickness = limit_thickness(*measure.value, mesh_, owned.element, options.of_shells);
    size.lofting_factor = section.lofting_factor;
  } else {
    const bool is_area = measure.quantity == Measure::Quantity::area;
    size.radius = is_area ? radius_of_area(*measure.value) : *measure.value;
  }
  return size;
}

void SizeFinder::report(const OwnedElement& owned, std::uint32_t block, const Measure& measure) {
  if (!reported_.insert(block).second) return;
  const std::string_view what = to_string(measure.quantity);
  const ContactSurface& surface = surfaces_[owned.surface];
  const std::string& attribute = sections_[block].attribute;
  std::string text = fmt::format("block '{}' ({}) ", mesh_.name({EntityKind::block, block}),
                                 topology(mesh_.blocks()[block].shape).name);
  if (measure.value) {
    text += fmt::format("cannot be lofted: the {} of element {} is {}", what, mesh_.element_id(owned.element),
                        *measure.value);
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
                                      const Mesh& mesh, const OwnedElements& owned,
                                      Diagnostics& diagnostics) {
  if (owned.elements.empty()) return {};
  SizeFinder finder(definition, region, mesh, owned.surfaces, diagnostics);
  std::vector<LoftSize> sizes;
  sizes.reserve(owned.elements.size());
  for (const OwnedElement& one : owned.elements) sizes.push_back(finder.find(one));
  return sizes;
}

}  // namespace contactsim
