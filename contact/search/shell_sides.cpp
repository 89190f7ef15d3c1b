// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/shell_sides.hpp"

#include <algorithm>

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

namespace {

ShellSides sides_of(const SurfacePair& pair, SurfaceIndex surface) {
  return pair.sides[surface == pair.first ? 0 : 1];
}

}  // namespace

bool takes_part(const SurfacePair& pair, const ContactFace& face, const ContactMesh& contact_mesh,
                const Mesh& mesh) {
  const ShellSides sides = sides_of(pair, face.surface);
  if (sides == ShellSides::both) return true;
  const auto& block = mesh.blocks()[mesh.block_of(face.side.element())];
  if (topology(block.shape).family != Family::shell) return true;
  constexpr int last_rim = 6;
  const int wanted = sides == ShellSides::top ? 1 : 2;
  if (face.side.side() <= last_rim) return face.side.side() == wanted;
  // Joints close what skins leave open at a fold: they are of the skins that they continue.
  return std::ranges::any_of(face.corners, [&](ContactNodeIndex corner) {
    return std::ranges::any_of(contact_mesh.faces_of_node.of(corner), [&](FaceIndex other) {
      return contact_mesh.faces[other].side.side() == wanted;
    });
  });
}

bool takes_part(const SurfacePair& pair, const SurfaceNode& node, const ContactMesh& contact_mesh,
                const Mesh& mesh) {
  if (sides_of(pair, node.surface) == ShellSides::both) return true;
  const auto own = contact_mesh.faces_of_node.of(node.node);
  return own.empty() || std::ranges::any_of(own, [&](FaceIndex face) {
           return contact_mesh.faces[face].surface == node.surface &&
                  takes_part(pair, contact_mesh.faces[face], contact_mesh, mesh);
         });
}

}  // namespace contactsim
