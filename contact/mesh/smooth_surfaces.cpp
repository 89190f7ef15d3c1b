// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/smooth_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "contact/mesh/feature_edges.hpp"
#include "contact/smoothing/round_fit.hpp"
#include "core/base/find_definition.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

/// Faces that turn by more than this cosine are not of one round surface: nine faces go once round.
constexpr double smooth_turn = 0.76;

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

SmoothingShapes shapes_of_deck(const SurfaceSmoothing& smoothing, const ContactModel& model,
                               const ShapeReader& reader) {
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

/// The parts of a surface that are connected by edges at which it turns smoothly, as lists of faces.
std::vector<std::vector<FaceIndex>> smooth_parts(const ContactKinematics& start, SurfaceIndex surface) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  IndexedVector<FaceIndex, std::uint8_t> is_taken(contact_mesh.faces.size(), 0);
  const auto normal_of = [&](FaceIndex face) -> Eigen::Vector3d {
    return start.area(contact_mesh.faces[face]).normalized();
  };
  std::vector<std::vector<FaceIndex>> parts;
  for (const FaceIndex seed : contact_mesh.faces_of(surface)) {
    if (is_taken[seed] != 0) continue;
    std::vector<FaceIndex>& part = parts.emplace_back(1, seed);
    is_taken[seed] = 1;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const ContactFace& face = contact_mesh.faces[part[i]];
      const std::size_t n = face.is_triangle() ? 3 : 4;
      for (std::size_t k = 0; k < n; ++k) {
        const auto beyond =
            find_face_beyond(contact_mesh, part[i], {face.corners[k], face.corners[(k + 1) % n]});
        if (!beyond || is_taken[*beyond] != 0) continue;
        if (!(normal_of(part[i]).dot(normal_of(*beyond)) > smooth_turn)) continue;
        is_taken[*beyond] = 1;
        part.push_back(*beyond);
      }
    }
  }
  return parts;
}

SurfacePart part_of(const ContactKinematics& start, const std::vector<FaceIndex>& faces) {
  SurfacePart part;
  std::set<std::uint32_t> nodes;
  for (const FaceIndex index : faces) {
    const ContactFace& face = start.contact_mesh().faces[index];
    const std::size_t n = face.is_triangle() ? 3 : 4;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < n; ++k) sum += start.x(face.corners[k]);
    part.centres.push_back(sum / static_cast<double>(n));
    part.areas.push_back(start.area(face));
    nodes.insert(face.corners.begin(), face.corners.end());
  }
  for (const std::uint32_t node : nodes) part.nodes.push_back(start.x(node));
  return part;
}

SurfaceShapes fitted_shapes(const ContactKinematics& start, SurfaceIndex surface) {
  SurfaceShapes shapes;
  for (const auto& faces : smooth_parts(start, surface)) {
    const PartFit fit = fit_part(part_of(start, faces));
    if (fit.shape) {
      shapes.fitted.push_back(*fit.shape);
      shapes.fitted.back().n_faces = faces.size();
    } else if (fit.is_flat) {
      ++shapes.n_flat;
    } else {
      shapes.least_residual =
          shapes.n_unfitted == 0 ? fit.least_residual : std::min(shapes.least_residual, fit.least_residual);
      ++shapes.n_unfitted;
    }
  }
  return shapes;
}

SmoothingShapes shapes_of_mesh(const ContactModel& model, const Mesh& mesh) {
  SmoothingShapes made{"AUTO", true,
                       IndexedVector<SurfaceIndex, SurfaceShapes>(model.surfaces.surfaces.size())};
  const ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  const ContactKinematics start = kinematics_of_mesh(contact_mesh, mesh);
  for (const SurfaceIndex i : indices(made.surfaces)) {
    const bool is_asked_for = std::ranges::any_of(model.pairs, [&](const SurfacePair& pair) {
      return pair.smoothing_choice.kind == SmoothingChoice::Kind::automatic &&
             (pair.first == i || pair.second == i);
    });
    if (is_asked_for) made.surfaces[i] = fitted_shapes(start, i);
  }
  return made;
}

/// Finds the smoothing of a pair, a new one at its first pair.
class SmoothingFinder {
 public:
  SmoothingFinder(const SimulationDefinition& definition, const ContactDefinition& contact, const Mesh& mesh,
                  ContactModel& model, Diagnostics& diagnostics)
      : contact_(contact), mesh_(mesh), model_(model), reader_(definition, diagnostics) {}

  OptionalIndex<std::uint32_t> find(const SmoothingChoice& choice) {
    if (choice.kind == SmoothingChoice::Kind::off) return std::nullopt;
    const bool is_automatic = choice.kind == SmoothingChoice::Kind::automatic;
    const auto is_it = [&](const SmoothingShapes& one) {
      return one.is_automatic == is_automatic && (is_automatic || fold(one.name) == fold(choice.name.text));
    };
    const auto known = std::ranges::find_if(model_.smoothings, is_it);
    if (known != model_.smoothings.end())
      return static_cast<std::uint32_t>(known - model_.smoothings.begin());
    if (is_automatic) {
      model_.smoothings.push_back(shapes_of_mesh(model_, mesh_));
    } else {
      const SurfaceSmoothing* found = find_by_name(contact_.smoothings, choice.name.text);
      if (found == nullptr) return std::nullopt;  // an error of the deck
      model_.smoothings.push_back(shapes_of_deck(*found, model_, reader_));
    }
    return static_cast<std::uint32_t>(model_.smoothings.size() - 1);
  }

 private:
  const ContactDefinition& contact_;
  const Mesh& mesh_;
  ContactModel& model_;
  ShapeReader reader_;
};

/// Whether a smoothing has a shape for a side that has faces.
bool smooths(const ContactModel& model, const SurfacePair& pair) {
  return std::ranges::any_of(std::array{pair.first, pair.second}, [&](SurfaceIndex surface) {
    return model.surfaces.surfaces[surface].kind == SurfaceKind::face &&
           !model.smoothings[*pair.smoothing].surfaces[surface].is_empty();
  });
}

void warn(const ContactDefinition& contact, const ContactModel& model, Diagnostics& diagnostics) {
  for (const SurfaceSmoothing& smoothing : contact.smoothings) {
    const auto is_it = [&](const SmoothingShapes& one) {
      return !one.is_automatic && fold(one.name) == fold(smoothing.name.text);
    };
    if (std::ranges::none_of(model.smoothings, is_it))
      diagnostics.add_warning(
          "smoothing-unused", smoothing.name.location,
          fmt::format("no pair of surfaces uses the smoothing '{}'", smoothing.name.text),
          "write SMOOTHING = " + smoothing.name.text + " in an INTERACTION or in INTERACTION DEFAULTS");
  }
  // Of the defaults some pairs may be flat; only when all are is it told, once.
  bool are_defaults_told = std::ranges::any_of(model.pairs, [&](const SurfacePair& pair) {
    return pair.is_from_defaults && pair.smoothing && smooths(model, pair);
  });
  for (const SurfacePair& pair : model.pairs) {
    if (!pair.smoothing || smooths(model, pair)) continue;
    if (pair.is_from_defaults && std::exchange(are_defaults_told, true)) continue;
    const auto& surfaces = model.surfaces.surfaces;
    const SmoothingShapes& smoothing = model.smoothings[*pair.smoothing];
    diagnostics.add_warning(
        "smoothing-without-effect", pair.location,
        fmt::format("the smoothing {} has no round shape for faces of '{}' or of '{}'", smoothing.name,
                    surfaces[pair.first].name, surfaces[pair.second].name),
        smoothing.is_automatic ? "the log says what fits; BEGIN SURFACE SMOOTHING gives a shape" : "");
  }
}

/// The shape of a surface that a face stands for: a given one, or the first fitted one that its corners lie
/// on.
struct ShapeOfFace {
  const RoundShape* shape;
  std::uint32_t number;
};
std::optional<ShapeOfFace> find_shape(const SurfaceShapes& shapes, const FaceCorners& corners) {
  if (!shapes.given.empty()) return ShapeOfFace{&shapes.given.front(), 0};
  for (std::uint32_t i = 0; i < shapes.fitted.size(); ++i) {
    const FittedShape& fitted = shapes.fitted[i];
    bool lies_on = true;
    for (Eigen::Index k = 0; k < 4; ++k) {
      const double radius = fitted.shape.radius_of(corners.col(k));
      // Overlap removal may have moved nodes by some more than the residual.
      lies_on = lies_on && std::abs(radius - fitted.radius) <= 2.0 * largest_residual * fitted.radius;
    }
    if (lies_on) return ShapeOfFace{&fitted.shape, i};
  }
  return std::nullopt;
}

}  // namespace

void find_smoothings(const SimulationDefinition& definition, const ContactDefinition& contact,
                     const Mesh& mesh, ContactModel& model, Diagnostics& diagnostics) {
  SmoothingFinder finder(definition, contact, mesh, model, diagnostics);
  for (SurfacePair& pair : model.pairs) pair.smoothing = finder.find(pair.smoothing_choice);
  if (!diagnostics.has_errors()) warn(contact, model, diagnostics);
}

void refit_smoothings(const Mesh& mesh, ContactModel& model) {
  for (SmoothingShapes& smoothing : model.smoothings) {
    if (!smoothing.is_automatic) continue;
    SmoothingShapes moved = shapes_of_mesh(model, mesh);
    for (const SurfaceIndex i : indices(moved.surfaces)) {
      if (moved.surfaces[i].fitted.size() < smoothing.surfaces[i].fitted.size()) continue;
      smoothing.surfaces[i] = std::move(moved.surfaces[i]);
    }
  }
}

void add_smooth_faces(const ContactModel& model, const ContactKinematics& start, ContactMesh& contact_mesh) {
  if (model.smoothings.empty()) return;
  SmoothFaces smooth(model.smoothings.size(), contact_mesh.faces.size());
  for (std::uint32_t s = 0; s < model.smoothings.size(); ++s) {
    for (const FaceIndex i : indices(contact_mesh.faces)) {
      const ContactFace& face = contact_mesh.faces[i];
      const FaceCorners corners = start.face_corners(i);
      const auto found = find_shape(model.smoothings[s].surfaces[face.surface], corners);
      if (!found) continue;
      auto made = SmoothFace::make(*found->shape, corners, face.is_triangle());
      if (made) smooth.add(s, i, found->number, std::move(*made));
    }
    for (const FaceIndex i : indices(contact_mesh.faces)) {
      SmoothFace* face = smooth.find(s, i);
      if (face == nullptr) continue;
      face->sharpness = sharpness_of(start, i, [&](FaceIndex beyond) { return smooth.go_on(s, i, beyond); });
    }
  }
  contact_mesh.smooth_faces = std::move(smooth);
}

}  // namespace contactsim
