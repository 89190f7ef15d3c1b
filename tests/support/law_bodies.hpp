// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/contact_bodies.hpp"

namespace contactsim::test {

inline const std::string by_nodes = "constraint formulation = node_face\n";
/// Nodes of both sides meet faces of the other.
inline const std::string both_ways = "constraint formulation = node_face \n";

/// A unit cube over the middle of one face of a plate, 3 x 3, under a friction model called m: one place of
/// faces, or four nodes of the cube over the plate. The penalty is 1000 per area, the area is 1.
///   model  its block and what it names, to the end
inline std::string law_deck(const std::string& model, const std::string& formulation = "") {
  const std::string sides =
      formulation == both_ways ? "surfaces = block_1 block_2\n" : "side a = block_1\nside b = block_2\n";
  return "skin all blocks = on\nbegin interaction\n" + sides +
         "friction model = m\npenalty stiffness = 1000\n" + formulation + "end\n" + model;
}

inline MeshBuilder law_mesh(double gap, double edge = 1.0) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .size = {3, 3, 1}});
  return b.add_hexes(
      {.id = 2, .origin = {0.7, 0.9, 1.0 + gap}, .size = {edge, edge, 1}, .share_nodes = false});
}

/// A PIECEWISE LINEAR function.
inline std::string line_function(const std::string& name, const std::string& values) {
  return "begin function " + name + "\ntype is piecewise linear\nbegin values\n" + values + "end\nend\n";
}

/// Moves the cube at a velocity over a step.
inline Eigen::Vector3d force_after(ContactBodies& bodies, const Eigen::Vector3d& way, double dt = 0.1) {
  bodies.set_velocity(1, way / dt);
  bodies.step(dt);
  return bodies.force_on(1);
}

inline double friction_work(const ContactBodies& bodies) {
  return bodies.contact.histories().front().friction_work;
}

}  // namespace contactsim::test
