// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/initial_gaps.hpp"

#include <cmath>

#include "contact/formulations/start_gaps.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

namespace {

void take(double gap, InitialGap& start) {
  if (!(start.smallest_gap <= gap)) start.smallest_gap = gap;
}

/// Counts a candidate, and its gap where it has one.
void note(std::optional<double> gap, InitialGap& start) {
  ++start.n_in_reach;
  if (gap) take(*gap, start);
}

/// Gaps to planes.
void add_planes(const ContactModel& model, const ContactKinematics& kinematics, InitialGaps& starts) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  for (const PairIndex i : indices(model.pairs)) {
    const SurfacePair& pair = model.pairs[i];
    const auto add = [&](std::uint32_t with_plane, std::uint32_t other) {
      for (const std::uint32_t plane : model.surfaces.surfaces[with_plane].analytic_planes) {
        const AnalyticPlane& wall = model.planes[plane];
        for (std::uint32_t n = contact_mesh.first_node[other]; n < contact_mesh.first_node[other + 1]; ++n) {
          const Eigen::Vector3d away = kinematics.x(contact_mesh.surface_nodes[n].node) - wall.origin;
          note(away.dot(wall.normal.normalized()) - contact_mesh.surface_nodes[n].radius, starts[i]);
        }
      }
    };
    add(pair.first, pair.second);
    if (pair.first != pair.second) add(pair.second, pair.first);
  }
}

}  // namespace

InitialGaps find_initial_gaps(const ContactModel& model, const Mesh& mesh, const DashOptions& dash) {
  InitialGaps starts(model.pairs.size());
  ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  add_smooth_faces(model, kinematics_of_mesh(contact_mesh, mesh), contact_mesh);
  const PairRules rules(model.pairs, std::vector<ActiveTimes>(model.pairs.size()),
                        model.surfaces.surfaces.size());
  ContactKinematics kinematics(contact_mesh);
  const Eigen::Matrix3Xd at_rest = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  const Motion motion{0.0, 0.0, mesh.coordinates(), at_rest};
  kinematics.move_nodes(motion);
  kinematics.bound_all();
  ContactSearch search(contact_mesh, mesh, rules, {}, dash);
  PairLists face_partners, node_faces;
  search.find_face_pairs(kinematics, motion, {}, face_partners);
  search.find_node_faces(kinematics, motion, {}, node_faces);
  for (std::uint32_t a = 0; a < face_partners.n_rows(); ++a) {
    for (const std::uint32_t b : face_partners.of(a)) {
      const PairIndex pair = *rules.find(contact_mesh.faces[a].surface, contact_mesh.faces[b].surface);
      const auto gap = find_start_gap(kinematics, *rules[pair].pair, a, b);
      note(gap ? std::optional(gap->smallest) : std::nullopt, starts[pair]);
    }
  }
  for (std::uint32_t row = 0; row < node_faces.n_rows(); ++row) {
    for (const std::uint32_t face : node_faces.of(row))
      ++starts[*rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface)]
            .n_in_reach;
    const auto nearest = find_start_gap(kinematics, rules, row, node_faces.of(row));
    if (nearest) take(nearest->smallest, starts[nearest->pair]);
  }
  add_planes(model, kinematics, starts);
  return starts;
}

}  // namespace contactsim
