// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/deck_shapes.hpp"

#include <algorithm>

#include "core/base/find_definition.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

/// Makes shapes of those of the deck.
class ShapeReader {
 public:
  ShapeReader(const SimulationDefinition& definition, Diagnostics& diagnostics)
      : definition_(definition), diagnostics_(diagnostics) {}

  std::optional<RoundShape> shape_of(const SmoothingRegion& region) const {
    return std::visit([&](const auto& shape) { return make(shape, region.location); }, *region.shape);
  }

 private:
  std::optional<RoundShape> make(const CircumferentialShape& shape, const DeckLocation& location) const {
    return about(shape.axis, location);
  }
  std::optional<RoundShape> make(const SphericalShape& shape, const DeckLocation&) const {
    const auto center = find(shape.center);
    if (!center) return std::nullopt;
    RoundShape made;
    made.kind = RoundShape::Kind::spherical;
    made.origin = *center;
    return made;
  }
  std::optional<RoundShape> make(const ToroidalShape& shape, const DeckLocation& location) const {
    auto made = about(shape.axis, location);
    if (!made) return std::nullopt;
    made->kind = RoundShape::Kind::toroidal;
    made->arc_radius = shape.radius;
    return made;
  }

  std::optional<Eigen::Vector3d> find(const PointReference& point) const {
    if (const auto* coordinates = std::get_if<Eigen::Vector3d>(&point)) return *coordinates;
    const auto* found = find_definition(definition_.points, std::get<DeckName>(point), "point", diagnostics_);
    return found ? std::optional(found->coordinates) : std::nullopt;
  }
  std::optional<RoundShape> about(const AxisReference& axis, const DeckLocation& location) const {
    if (!axis.axis) return through(find((*axis.points)[0]), find((*axis.points)[1]), location);
    const auto* found = find_definition(definition_.axes, *axis.axis, "axis", diagnostics_);
    if (found == nullptr) return std::nullopt;
    const auto point = find(found->point);
    if (!found->direction) return through(point, find(*found->second_point), location);
    const auto* direction =
        find_definition(definition_.directions, *found->direction, "direction", diagnostics_);
    if (!point || direction == nullptr) return std::nullopt;
    return through(point, Eigen::Vector3d(*point + direction->vector.stableNormalized()), location);
  }
  std::optional<RoundShape> through(const std::optional<Eigen::Vector3d>& first,
                                    const std::optional<Eigen::Vector3d>& second,
                                    const DeckLocation& location) const {
    if (!first || !second) return std::nullopt;
    const Eigen::Vector3d way = (*second - *first).stableNormalized();
    if (way.norm() > 0.5) {
      RoundShape made;
      made.origin = *first;
      made.axis = way;
      return made;
    }
    diagnostics_.add_error(location, "the axis of the smoothing runs through one point only",
                           "its two points lie at one place");
    return std::nullopt;
  }

  const SimulationDefinition& definition_;
  Diagnostics& diagnostics_;
};

}  // namespace

SmoothingShapes shapes_of_deck(const SurfaceSmoothing& smoothing, const ContactModel& model,
                               const SimulationDefinition& definition, Diagnostics& diagnostics) {
  const ShapeReader reader(definition, diagnostics);
  const auto& surfaces = model.surfaces.surfaces;
  SmoothingShapes made{smoothing.name.text, false,
                       IndexedVector<SurfaceIndex, SurfaceShapes>(surfaces.size())};
  for (const SmoothingRegion& region : smoothing.regions) {
    if (!region.shape) continue;
    const auto shape = reader.shape_of(region);
    if (!shape) continue;
    for (const SurfaceIndex i : indices(surfaces)) {
      const auto names = [&](const DeckName& name) {
        return fold(name.text) == "all" || fold(name.text) == fold(surfaces[i].name);
      };
      if (std::ranges::any_of(region.surfaces, names)) made.surfaces[i].given.assign(1, *shape);
    }
  }
  return made;
}

}  // namespace contactsim
