// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/line_section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/elements/element_table.hpp"
#include "core/elements/linear_advice.hpp"
#include "core/mesh/element_attributes.hpp"

namespace contactsim {

namespace {

/// Reads sections for one block.
class LineReader {
 public:
  LineReader(const Mesh& mesh, std::uint32_t block, const DeckLocation& location, Diagnostics& diagnostics)
      : mesh_(mesh),
        block_(mesh.blocks()[block]),
        name_(mesh.name({EntityKind::block, block})),
        location_(location),
        diagnostics_(diagnostics) {}

  std::optional<LineSetup> read(const BeamSection& section) const {
    std::string problem;
    const auto beam = make_beam_shape(section, problem);
    if (!beam) return fail(fmt::format("{}: its beam section {}", name_, problem));
    return finish({nullptr, *beam, std::vector<double>(block_.n_elements, beam->area), {}}, "beam");
  }

  std::optional<LineSetup> read(const TrussSection& section) const {
    LineSetup setup;
    setup.preload = {section.initial_load, section.period};
    return with_sizes(std::move(setup), section.area, "area", "truss");
  }

  std::optional<LineSetup> read(const ParticleSection& section) const {
    return with_sizes({}, section.radius, "radius", "particle");
  }

  template <class Section>
  std::optional<LineSetup> read(const Section&) const {
    return fail(fmt::format(
        "{} has elements of type {}, which need a {} SECTION", name_, topology(block_.shape).name,
        block_.shape == Shape::sphere ? "PARTICLE or POINT MASS" : "BEAM, TRUSS, SPRING or DAMPER"));
  }

  std::optional<LineSetup> fail(std::string text) const {
    diagnostics_.add_error(location_, std::move(text));
    return std::nullopt;
  }

 private:
  std::optional<LineSetup> with_sizes(LineSetup setup, std::optional<double> of_section,
                                      std::string_view what, std::string_view formulation) const {
    setup.beam.fibres = {{}};
    for (std::uint32_t element = 0; element < block_.n_elements; ++element) {
      const auto size = of_section ? of_section : find_usual_attribute(block_, element, what);
      if (!size)
        return fail(fmt::format("{} has no {}: neither a section nor an attribute on the mesh", name_, what));
      if (!(*size > 0.0) || !std::isfinite(*size))
        return fail(fmt::format("{}: the {} of its element {} is {}", name_, what,
                                mesh_.element_id({block_.first_element.value + element}), *size));
      setup.sizes.push_back(*size);
    }
    return finish(std::move(setup), formulation);
  }

  std::optional<LineSetup> finish(LineSetup setup, std::string_view formulation) const {
    setup.element = find_line_element(block_.shape, formulation);
    if (setup.element == nullptr) {
      diagnostics_.add_error(location_,
                             fmt::format("{} has elements of type {}, which its {} section is not for", name_,
                                         topology(block_.shape).name, formulation),
                             linear_advice(block_.shape, block_.id));
      return std::nullopt;
    }
    return setup;
  }

  const Mesh& mesh_;
  const ElementBlock& block_;
  std::string name_;
  DeckLocation location_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<LineSetup> make_line_setup(const SectionDefinition* section, const Mesh& mesh,
                                         std::uint32_t block, const DeckLocation& location,
                                         Diagnostics& diagnostics) {
  const DeckLocation& at = section != nullptr ? section->name.location : location;
  const LineReader reader(mesh, block, at, diagnostics);
  if (section == nullptr) {
    // Particles may take everything from the mesh; lines do not say whether they bend.
    if (mesh.blocks()[block].shape == Shape::sphere) return reader.read(ParticleSection{});
    return reader.read(SolidSection{});
  }
  return std::visit([&](const auto& properties) { return reader.read(properties); }, section->properties);
}

}  // namespace contactsim
