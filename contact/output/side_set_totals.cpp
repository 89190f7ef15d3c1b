// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/side_set_totals.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace contactsim {

namespace {

/// Adds what acts on the faces of a side set.
class SideSum {
 public:
  SideSum(const ContactForce& force, std::span<const ElementSide> sides)
      : force_(force), contact_mesh_(force.contact_mesh()), sides_(sides) {}

  void add(const ContactPoint& point) {
    if (!point.touches()) return;
    const double first = share_of_first(point), second = share_of_second(point);
    if (first == 0.0 && second == 0.0) return;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      place += point.first.weights[static_cast<Eigen::Index>(k)] * force_.position(point.first.nodes[k]);
    const double net = first - second, both = first + second;
    total_.add(place, net * point.force * point.normal, net * point.tangential);
    total_.normal_sum += both * point.force;
    total_.centre += both * point.force * place;
    total_.area += both * point.area;
  }

  void add(const ConstraintForces& held) {
    const InterfaceConstraint& tie = held.constraint;
    const CornerForces& forces = held.forces;
    if (forces.normal.isZero()) return;
    const double first =
        tie.is_node ? share_of_node(tie.row(), forces.normal) : share_of_face(tie.first_face());
    const double second = share_of_face(tie.second);
    const double net = first - second, both = first + second;
    if (both == 0.0) return;
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector3d force = forces.forces.col(static_cast<Eigen::Index>(k));
      const Eigen::Vector3d normal = forces.normal.dot(force) * forces.normal;
      const Eigen::Vector3d place = force_.position(tie.nodes[k]);
      total_.add(place, net * normal, net * (force - normal));
      total_.normal_sum += both * normal.norm();
      total_.centre += both * normal.norm() * place;
    }
    total_.area += both * tie.area;
  }

  const ContactTotal& total() const { return total_; }

 private:
  bool holds(ElementSide side) const { return std::ranges::binary_search(sides_, side); }
  double share_of_face(FaceIndex face) const { return holds(contact_mesh_.faces[face].side) ? 1.0 : 0.0; }

  double share_of_edge(EdgeIndex index) const {
    const ContactEdge& edge = contact_mesh_.edges[index];
    if (!edge.faces) return holds(edge.side) ? 1.0 : 0.0;
    return 0.5 * (share_of_face((*edge.faces)[0]) + share_of_face((*edge.faces)[1]));
  }

  Eigen::Vector3d area_vector(const ContactFace& face) const {
    const auto x = [&](std::size_t k) { return force_.position(face.corners[k]); };
    return (x(2) - x(0)).cross(x(3) - x(1)) / (face.is_triangle() ? 3.0 : 4.0);
  }

  /// The part of a surface node's force that its faces in the set get.
  ///   normal  towards the node [1]
  double share_of_node(SurfaceNodeIndex row, const Eigen::Vector3d& normal) const {
    const SurfaceNode& node = contact_mesh_.surface_nodes[row];
    double against = 0.0, against_in = 0.0, area = 0.0, area_in = 0.0;
    for (const FaceIndex index : contact_mesh_.faces_of_node.of(node.node)) {
      const ContactFace& face = contact_mesh_.faces[index];
      if (face.surface != node.surface) continue;
      const Eigen::Vector3d vector = area_vector(face);
      const double facing = std::max(0.0, -vector.dot(normal)), is_in = holds(face.side) ? 1.0 : 0.0;
      against += facing;
      against_in += is_in * facing;
      area += vector.norm();
      area_in += is_in * vector.norm();
    }
    if (against > 0.0) return against_in / against;
    if (area > 0.0) return area_in / area;
    return holds(node.side) ? 1.0 : 0.0;
  }

  double share_of_first(const ContactPoint& point) const {
    if (point.is_of_edges) return share_of_edge(point.first_edge());
    return point.first.is_node() ? share_of_node(point.row(), point.normal)
                                 : share_of_face(point.first_face());
  }

  double share_of_second(const ContactPoint& point) const {
    if (point.second.weights.isZero(0.0)) return 0.0;
    return point.is_of_edges ? share_of_edge(point.second_edge()) : share_of_face(point.second_face());
  }

  const ContactForce& force_;
  const ContactMesh& contact_mesh_;
  std::span<const ElementSide> sides_;
  ContactTotal total_;
};

}  // namespace

ContactTotal sum_over_sides(const ContactForce& force, std::span<const ElementSide> sides) {
  SideSum sum(force, sides);
  for (const ContactPoint& point : force.points()) sum.add(point);
  for (const ConstraintForces& held : force.constraint_forces()) sum.add(held);
  return sum.total();
}

}  // namespace contactsim
