// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/smooth_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "contact/mesh/deck_shapes.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "contact/mesh/fitted_shapes.hpp"
#include "contact/smoothing/round_fit.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

/// Finds the smoothing of a pair, a new one at its first pair.
class SmoothingFinder {
 public:
  SmoothingFinder(const SimulationDefinition& definition, const ContactDefinition& contact, const Mesh& mesh,
                  ContactModel& model, Diagnostics& diagnostics)
      : contact_(contact), mesh_(mesh), model_(model), definition_(definition), diagnostics_(diagnostics) {}

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
      model_.smoothings.push_back(shapes_of_deck(*found, model_, definition_, diagnostics_));
    }
    return static_cast<std::uint32_t>(model_.smoothings.size() - 1);
  }

 private:
  const ContactDefinition& contact_;
  const Mesh& mesh_;
  ContactModel& model_;
  const SimulationDefinition& definition_;
  Diagnostics& diagnostics_;
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
  // Of the defaults some pairs may be flat; only when all are is it reported, once.
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
