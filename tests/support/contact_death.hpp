// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "support/contact_bodies.hpp"

namespace contactsim::test {

/// Lets elements of some parts die: contact mesh and kinematics go over to what is left. The properties that
/// a test has given to faces, nodes and edges stay with those that are still there.
///   contact_lines  that the parts are made of
inline ContactRemap let_die(ContactParts& parts, const std::string& contact_lines,
                            const std::vector<std::int64_t>& element_ids) {
  const ContactMesh before = parts.contact_mesh;
  const Modelled left = make_model(parts.mesh, contact_lines, "", all_but(parts.mesh, element_ids));
  parts.contact_mesh = make_contact_mesh(left, parts.mesh);
  ContactRemap remap = make_contact_remap(before, parts.contact_mesh);
  const auto keep = [](const auto& positions, const auto& old, auto& now) {
    for (const auto i : indices(old)) {
      if (positions[i]) now[*positions[i]].penalty_properties = old[i].penalty_properties;
    }
  };
  keep(remap.faces, before.faces, parts.contact_mesh.faces);
  keep(remap.rows, before.surface_nodes, parts.contact_mesh.surface_nodes);
  keep(remap.edges, before.edges, parts.contact_mesh.edges);
  for (const EdgeIndex i : indices(before.edges)) {
    if (remap.edges[i]) parts.contact_mesh.edges[*remap.edges[i]].width = before.edges[i].width;
  }
  parts.kinematics.remap(remap, parts.motion());
  parts.move();
  return remap;
}

}  // namespace contactsim::test
