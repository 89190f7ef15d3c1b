// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/automatic_lengths.hpp"

#include <array>
#include <cmath>

#include "contact/formulations/near_pairs.hpp"
#include "contact/mesh/mean_edge.hpp"

namespace contactsim {

namespace {

/// Half the element behind a face: of contact that has not begun, and of overlaps that are removed.
constexpr double overlap_share = 0.5;

AutomaticLengths lengths_of(const ContactKinematics& start, SurfaceIndex surface, double size_share) {
  const ContactMesh& contact_mesh = start.contact_mesh();
  AutomaticLengths lengths;
  for (const FaceIndex i : contact_mesh.faces_of(surface)) {
    const ContactFace& face = contact_mesh.faces[i];
    const FaceBound& bound = start.bound(i);
    lengths.normal.add(size_share * std::sqrt(start.area(face).norm()));
    lengths.tangential.add(automatic_beyond * static_cast<double>(bound.radius()));
    lengths.overlap_normal.add(overlap_share * face.penalty_properties.thickness);
    lengths.capture.add(capture_tolerance_of({}, bound, size_share));
  }
  if (lengths.normal.exists()) return lengths;
  for (const SurfaceNodeIndex i : contact_mesh.rows_of(surface))
    lengths.normal.add(size_share * std::sqrt(contact_mesh.surface_nodes[i].area));
  return lengths;
}

}  // namespace

void AutomaticLengths::add(const AutomaticLengths& other) {
  normal.add(other.normal);
  tangential.add(other.tangential);
  overlap_normal.add(other.overlap_normal);
  capture.add(other.capture);
  edge.add(other.edge);
}

IndexedVector<PairIndex, AutomaticLengths> find_automatic_lengths(const ContactModel& model, const Mesh& mesh,
                                                                  const DashOptions& dash) {
  const ContactMesh contact_mesh = make_contact_mesh(model, mesh);
  ContactKinematics start = kinematics_of_mesh(contact_mesh, mesh);
  start.bound_all();
  IndexedVector<SurfaceIndex, AutomaticLengths> of_surface;
  for (const SurfaceIndex surface : indices(model.surfaces.surfaces))
    of_surface.push_back(lengths_of(start, surface, dash.search_length_scaling));
  IndexedVector<PairIndex, AutomaticLengths> lengths;
  for (const SurfacePair& pair : model.pairs) {
    AutomaticLengths& own = lengths.emplace_back();
    for (const SurfaceIndex surface : std::array{pair.first, pair.second}) own.add(of_surface[surface]);
    if (pair.search_distance || pair.gap_closure) own.edge.add(mean_edge(start, pair));
  }
  return lengths;
}

}  // namespace contactsim
