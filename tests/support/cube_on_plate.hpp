// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "support/contact_bodies.hpp"

namespace contactsim::test {

/// A plate of 3 x 3 unit cells and a cube on it that stands over the first cells in x, numbered in either
/// order. The penalty is 1000 per area, the cube covers 0.25.
struct CubeOnPlate : ContactParts {
  explicit CubeOnPlate(const std::string& lines = "", bool cube_first = false)
      : ContactParts(make(cube_first), general_contact("penalty stiffness = 1000\n" + lines)),
        contacts(setup()),
        cube(cube_first ? 0 : 1) {
    search();
    contacts.take_candidates(face_partners);
  }
  static MeshBuilder make(bool cube_first) {
    const test::Box plate{.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}, .share_nodes = false},
        small{.id = 2, .origin = {0.2, 1.1, 1.0}, .size = {0.5, 0.5, 1.0}, .share_nodes = false};
    MeshBuilder b;
    if (cube_first) b.add_hexes(small);
    b.add_hexes(plate);
    if (!cube_first) b.add_hexes(small);
    return b;
  }

  FaceFaceContacts contacts;
  std::uint32_t cube;  ///< its block
  double size = 0.0;   ///< of the last step

  /// Moves the cube in a step of size 1, or puts it there without a velocity.
  void move_cube(const Eigen::Vector3d& way, bool in_a_step = true) {
    v.setZero();
    size = in_a_step ? 1.0 : 0.0;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const auto& nodes = mesh.blocks()[cube].nodes;
      if (std::count(nodes.begin(), nodes.end(), NodeIndex{static_cast<std::uint32_t>(i)}) == 0) continue;
      x.col(i) += way;
      if (in_a_step) v.col(i) = way;
    }
    move();
  }
  void renew_candidates() {
    search(contacts.depths());
    contacts.take_candidates(face_partners);
  }
  std::vector<ContactPoint> find() {
    std::vector<ContactPoint> points;
    contacts.begin_step();
    contacts.begin_detection(context(size));
    contacts.detect(context(size), {0, contacts.n_rows()}, points);
    contacts.update(context(size), {0, contacts.n_rows()}, points);
    return points;
  }
  /// The sum of the forces on the cube.
  Eigen::Vector3d force_on_cube(const std::vector<ContactPoint>& points) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const ContactPoint& point : points)
      sum += (contact_mesh.faces[point.first_face()].surface == SurfaceIndex{cube} ? 1.0 : -1.0) *
             point.force_on_first();
    return sum;
  }
};

}  // namespace contactsim::test
