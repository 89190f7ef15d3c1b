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
    const auto add = [&](SurfaceIndex with_plane, SurfaceIndex other) {
      for (const std::uint32_t plane : model.surfaces.surfaces[with_plane].analytic_planes) {
        const AnalyticPlane& wall = model.planes[plane];
        for (const SurfaceNodeIndex row : contact_mesh.rows_of(other)) {
          const Eigen::Vector3d away = kinematics.x(contact_mesh.surface_nodes[row].node) - wall.origin;
          note(away.dot(wall.normal.normalized()) - contact_mesh.surface_nodes[row].radius, starts[i]);
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
  FacePairLists face_partners;
  NodeFaceLists node_faces;
  search.find_face_pairs(kinematics, motion, {}, face_partners);
  search.find_node_faces(kinematics, motion, {}, node_faces);
  for (const FaceIndex a : face_partners.rows()) {
    for (const FaceIndex b : face_partners.of(a)) {
      const PairIndex pair = *rules.find(contact_mesh.faces[a].surface, contact_mesh.faces[b].surface);
      const auto gap = find_start_gap(kinematics, *rules[pair].pair, a, b);
      note(gap ? std::optional(gap->smallest) : std::nullopt, starts[pair]);
    }
  }
  for (const SurfaceNodeIndex row : node_faces.rows()) {
    for (const FaceIndex face : node_faces.of(row))
      ++starts[*rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface)]
            .n_in_reach;
    const auto nearest = find_start_gap(kinematics, rules, row, node_faces.of(row));
    if (nearest) take(nearest->smallest, starts[nearest->pair]);
  }
  add_planes(model, kinematics, starts);
  return starts;
}

}  // namespace contactsim
