// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// A node of a contact surface that has gone through the mid surface of a lofted shell.
struct SheetCrossing {
  PairIndex pair;
  NodeIndex node;  ///< of the mesh
};

/// Finds what has gone from one side of a lofted shell to the other while all nodes went straight ahead at
/// constant speed: the roots of the cubic in time at which a node and three corners of a triangle of a mid
/// surface lie in one plane, as far as the node is then between these, and its gap to the face has another
/// sign at the end. Faces of the node itself, and what no pair is of, are
/// left out.
///   before, now  [n_contact_nodes] the mesh nodes that contact nodes hang on [length]
/// Returns each node of a pair once, by pair, then node.
/// Source: R. Bridson, R. Fedkiw, J. Anderson: Robust treatment of collisions, contact and friction for cloth
/// animation, ACM Trans. Graph. 21 (2002), section 6.
std::vector<SheetCrossing> find_crossed_sheets(const ContactMesh& contact_mesh, const PairRules& rules,
                                               IndexedSpan<ContactNodeIndex, const Eigen::Vector3d> before,
                                               IndexedSpan<ContactNodeIndex, const Eigen::Vector3d> now);

/// Whether a point goes through a triangle while all four go straight ahead at constant speed, and is on the
/// other side of its plane at the end.
///   point     before and now [length]
///   triangle  [3 corners] before and now [length]
bool goes_through(const std::array<Eigen::Vector3d, 2>& point,
                  const std::array<std::array<Eigen::Vector3d, 2>, 3>& triangle);

}  // namespace contactsim
