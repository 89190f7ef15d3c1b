// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

namespace contactsim::test {

inline const std::string node_face = "constraint formulation = node_face\n";

/// A test case that says this runs with faces on faces, then with nodes on faces.
inline std::string formulation() { return GENERATE(std::string(), node_face); }

/// A unit cube, block_1, and another one above it, block_2, whose edges are cut into cells.
///   aside  of the upper one along x [length]
inline MeshBuilder stacked_cubes(double gap, int cells = 1, double aside = 0.0) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {cells, cells, cells}, .size = {1, 1, 1}});
  return b.add_hexes({.id = 2,
                      .cells = {cells, cells, cells},
                      .origin = {aside, 0, 1.0 + gap},
                      .size = {1, 1, 1},
                      .share_nodes = false});
}

/// The force that lifts the upper body [force].
inline double lift(const ContactBodies& bodies) { return bodies.force_on(1).z(); }

}  // namespace contactsim::test
