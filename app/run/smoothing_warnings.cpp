// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/smoothing_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace contactsim {

namespace {

/// Cosine of the angle by which a face may lean on the round shape that it stands for: half the turn between
/// two faces of twelve.
constexpr double askew = 0.966;

/// Strain from which on round shapes of the start may be wrong.
constexpr double large_strain = 0.1;

/// The mesh nodes of a contact face's corners, a triangle's last twice.
std::array<NodeIndex, 4> mesh_nodes_of(const ContactMesh& contact_mesh, const ContactFace& face) {
  std::array<NodeIndex, 4> nodes;
  for (std::size_t k = 0; k < 4; ++k) nodes[k] = NodeIndex{contact_mesh.mesh_nodes[face.corners[k]]};
  return nodes;
}

/// Calls visit(face, its number) for all smoothed faces of a surface.
template <class Visit>
void visit_smoothed(const ContactMesh& contact_mesh, std::uint32_t smoothing, SurfaceIndex surface,
                    const Visit& visit) {
  for (const FaceIndex i : contact_mesh.faces_of(surface)) {
    if (contact_mesh.smooth_faces.find(smoothing, i) != nullptr) visit(contact_mesh.faces[i]);
  }
}

/// Whether a face looks along the way to its middle, as far as the shape says which way that is.
bool is_askew(const RoundShape& shape, const FaceCorners& corners, bool is_triangle) {
  Eigen::Vector3d normal = area_vector(corners);
  if (shape.kind == RoundShape::Kind::circumferential) normal -= shape.axis.dot(normal) * shape.axis;
  const Eigen::Vector3d way = shape.way_to(make_face_map(corners, is_triangle).centre());
  return std::abs(normal.dot(way)) < askew * normal.norm() * way.norm();
}

std::string pair_names(const SurfacePair& pair, const ContactModel& contact) {
  const auto& surfaces = contact.surfaces.surfaces;
  return fmt::format("'{}' and '{}'", surfaces[pair.first].name, surfaces[pair.second].name);
}

void warn_of_pairs(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings) {
  constexpr const char* id = "smoothing-without-effect";
  std::set<std::string> reported;
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!pair.smoothing) continue;
    const PairRule& rule = force.rules()[i];
    std::string text, hint;
    if (rule.only_ties()) {
      text = "ties hold faces as they find them, with or without SMOOTHING";
    } else if (rule.may_act_apart() && pair.formulation == ConstraintFormulation::face_face) {
      text = "the law acts across the gaps of faces, SMOOTHING on what presses only";
      hint = "NODE_FACE counts all gaps from the round surfaces";
    } else {
      continue;
    }
    if (reported.insert(to_string(pair.location)).second)
      warnings.add_warning(id, pair.location, pair_names(pair, contact) + ": " + text, hint);
  }
}

void warn_of_shapes(const ContactMesh& contact_mesh, const ContactModel& contact, std::uint32_t smoothing,
                    SurfaceIndex surface, const Mesh& mesh, Diagnostics& warnings) {
  const SmoothingShapes& shapes = contact.smoothings[smoothing];
  const auto& given = shapes.surfaces[surface].given;
  if (given.empty() || contact_mesh.faces_of(surface).size() == 0) return;
  const auto& x = mesh.coordinates();
  std::size_t n = 0, n_askew = 0;
  visit_smoothed(contact_mesh, smoothing, surface, [&](const ContactFace& face) {
    const auto nodes = mesh_nodes_of(contact_mesh, face);
    FaceCorners corners;
    for (std::size_t k = 0; k < 4; ++k) corners.col(static_cast<Eigen::Index>(k)) = x.col(nodes[k].value);
    ++n;
    n_askew += is_askew(given.front(), corners, face.is_triangle()) ? 1 : 0;
  });
  const std::string& name = contact.surfaces.surfaces[surface].name;
  if (n == 0) {
    warnings.add_warning("smoothing-without-effect", {},
                         fmt::format("no face of '{}' goes round the shape that the smoothing '{}' gives it",
                                     name, shapes.name),
                         "faces that look along the axis stand for themselves");
  } else if (n_askew > 0) {
    warnings.add_warning(
        "smoothing-askew", {},
        fmt::format("{} of {} faces of '{}' lean by more than 15 degrees on the shape that the "
                    "smoothing '{}' gives them",
                    n_askew, n, name, shapes.name),
        "the axis or centre may be another one");
  }
}

}  // namespace

void warn_of_smoothings(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                        Diagnostics& warnings) {
  warn_of_pairs(force, contact, warnings);
  for (std::uint32_t s = 0; s < contact.smoothings.size(); ++s) {
    for (const SurfaceIndex i : indices(contact.surfaces.surfaces))
      warn_of_shapes(force.contact_mesh(), contact, s, i, mesh, warnings);
  }
}

void warn_of_strain(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                    const State& state, Diagnostics& warnings) {
  const ContactMesh& contact_mesh = force.contact_mesh();
  std::set<SurfaceIndex> reported;
  for (std::uint32_t s = 0; s < contact.smoothings.size(); ++s) {
    for (const SurfaceIndex i : indices(contact.surfaces.surfaces)) {
      double strain = 0.0;
      visit_smoothed(contact_mesh, s, i, [&](const ContactFace& face) {
        const auto nodes = mesh_nodes_of(contact_mesh, face);
        for (std::size_t k = 0; k < 4; ++k) {
          const NodeIndex a = nodes[k], b = nodes[(k + 1) % 4];
          if (a == b) continue;
          const auto length = [&](const auto& x) { return (x.col(a.value) - x.col(b.value)).norm(); };
          strain = std::max(strain, std::abs(length(state.coordinates) / length(mesh.coordinates()) - 1.0));
        }
      });
      if (!(strain > large_strain) || !reported.insert(i).second) continue;
      warnings.add_warning(
          "smoothing-strained", {},
          fmt::format(
              "edges of '{}' have changed their length by {:.0f} %, and its round shape is that of the "
              "start",
              contact.surfaces.surfaces[i].name, 100.0 * strain),
          "smoothing is for small strains; SMOOTHING = OFF takes the faces as they are");
    }
  }
}

}  // namespace contactsim
