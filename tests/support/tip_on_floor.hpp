// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "support/contact_bodies.hpp"

namespace contactsim::test {

/// Of the penalty of TipOnFloor, per area.
inline constexpr double tip_stiffness = 1000.0;
/// The tip's third of the three faces around it: each is half the product of (1, 0, 1) and its neighbour.
inline const double tip_area = std::sqrt(3.75) / 2.0;

/// A floor of 2 x 2 unit cells, perhaps with a wall at x = 2, and a tetrahedron that stands on its tip.
struct TipOnFloor : ContactParts {
  explicit TipOnFloor(const std::string& lines = "", bool with_wall = false)
      : ContactParts(make(with_wall), general_contact("penalty stiffness = 1000\n" + lines,
                                                      "contact surface floor contains block_1\n"
                                                      "contact node set tip contains tip\n")),
        contacts(setup()) {}
  static MeshBuilder make(bool with_wall) {
    MeshBuilder b;
    b.add_hexes({.id = 3, .origin = {50, 0, 0}});
    const double h = std::sqrt(3.0) / 2.0;
    const std::uint32_t first = b.add_node({0, 0, 0}).value;
    b.add_node({1, 0, 1});
    b.add_node({-0.5, h, 1});
    b.add_node({-0.5, -h, 1});
    b.add_block(2, "", Shape::tet4, {first, first + 1, first + 2, first + 3});
    b.add_node_set(1, "tip", std::vector<std::uint32_t>{first});
    std::vector<std::uint32_t> nodes;
    const auto add_cell = [&](int i, int j, int k) {
      for (const auto& [a, c, d] :
           {std::array{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})
        nodes.push_back(static_cast<std::uint32_t>(((k + d) * 3 + j + c) * 4 + i + a) + first + 4);
    };
    for (int k = 0; k < 3; ++k) {
      for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) b.add_node({double(i), double(j), k - 1.0});
      }
    }
    for (int j = 0; j < 2; ++j) {
      add_cell(0, j, 0);
      add_cell(1, j, 0);
      if (with_wall) add_cell(2, j, 0);
      if (with_wall) add_cell(2, j, 1);
    }
    b.add_block(1, "", Shape::hex8, nodes);
    return b;
  }

  NodeFaceContacts contacts;

  /// Puts the tip somewhere, in a step of size 1 or without a velocity, and finds what it touches.
  std::vector<ContactPoint> put(const Eigen::Vector3d& entity, bool in_a_step = false) {
    const Eigen::Vector3d way = entity - x.col(8);
    v.setZero();
    for (Eigen::Index i = 8; i < 12; ++i) {
      x.col(i) += way;
      if (in_a_step) v.col(i) = way;
    }
    const std::vector<float> depths = contacts.depths();
    search({}, depths);
    contacts.take_candidates(node_faces);
    return look(in_a_step ? 1.0 : 0.0);
  }
  std::vector<ContactPoint> look(double dt) {
    std::vector<ContactPoint> points;
    contacts.begin_detection(context(dt));
    contacts.detect(context(dt), {0, contacts.n_rows()}, points);
    contacts.update(context(dt), {0, contacts.n_rows()}, points);
    return points;
  }
};

}  // namespace contactsim::test
