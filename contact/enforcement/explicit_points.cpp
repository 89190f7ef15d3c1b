// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/explicit_points.hpp"

#include <map>
#include <utility>

namespace contactsim {

namespace {

/// What the points of faces around a surface node press it with.
struct NodeForce {
  double area = 0.0;                                 // [length^2]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   // [force]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // towards it, of any length
};

/// One side of a contact point of faces.
struct FaceSide {
  const ContactPointSide& side;
  FaceIndex face, other;
  double sign;  // of what it feels, as the first side does
};

}  // namespace

std::vector<ContactPoint> explicit_points_of(std::span<const ContactPoint> of_load_steps,
                                             const SurfacePairs& pairs, const ContactMesh& contact_mesh) {
  std::vector<ContactPoint> points;
  std::map<SurfaceNodeIndex, NodeForce> of_rows;
  std::map<std::pair<SurfaceNodeIndex, FaceIndex>, ContactPoint> met;
  const auto add = [&](const ContactPoint& point, const FaceSide& at) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = at.side.weights[static_cast<Eigen::Index>(k)];
      const auto row = contact_mesh.find_row(at.side.nodes[k], contact_mesh.faces[at.face].surface);
      if (!row || !(weight > 0.0)) continue;
      NodeForce& of_row = of_rows[*row];
      of_row.area += weight * point.area;
      of_row.force += at.sign * weight * point.force_on_first();
      of_row.normal += at.sign * weight * point.area * point.normal;
      ContactPoint& of_face = met[{*row, at.other}];
      of_face.pair = point.pair;
      of_face.first_entity = row->value;
      of_face.second_entity = at.other.value;
      of_face.first.nodes.fill(at.side.nodes[k]);
      of_face.second.weights = Eigen::Vector4d::UnitX();
      of_face.area += weight * point.area;
    }
  };
  for (const ContactPoint& point : of_load_steps) {
    const bool is_of_faces = !point.first.is_node() && !point.is_of_edges;
    if (!is_of_faces || pairs[point.pair].formulation == ConstraintFormulation::face_face) {
      points.push_back(point);
      continue;
    }
    add(point, {point.first, point.first_face(), point.second_face(), 1.0});
    add(point, {point.second, point.second_face(), point.first_face(), -1.0});
  }
  for (auto& [key, point] : met) {
    const NodeForce& of_row = of_rows[key.first];
    point.area *= 0.5;
    const Eigen::Vector3d force = point.area / of_row.area * of_row.force;
    point.normal = of_row.normal.normalized();
    point.force = force.dot(point.normal);
    point.tangential = force - point.force * point.normal;
    points.push_back(point);
  }
  return points;
}

}  // namespace contactsim
