// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/fitted_shapes.hpp"

#include <algorithm>
#include <set>

#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "contact/smoothing/round_fit.hpp"

namespace contactsim {

namespace {

/// Faces that turn by more than this cosine are not of one round surface: nine faces go once round.
constexpr double smooth_turn = 0.76;

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
  std::set<ContactNodeIndex> nodes;
  for (const FaceIndex index : faces) {
    const ContactFace& face = start.contact_mesh().faces[index];
    const std::size_t n = face.is_triangle() ? 3 : 4;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < n; ++k) sum += start.x(face.corners[k]);
    part.centres.push_back(sum / static_cast<double>(n));
    part.areas.push_back(start.area(face));
    nodes.insert(face.corners.begin(), face.corners.end());
  }
  for (const ContactNodeIndex node : nodes) part.nodes.push_back(start.x(node));
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

}  // namespace

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

}  // namespace contactsim
