// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/finer_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contactsim {

namespace {

/// The size of a surface's faces, and how stiff what they belong to is.
struct SurfaceGrain {
  double node_area =
      std::numeric_limits<double>::infinity();  // geometric mean; infinite without nodes [length^2]
  double modulus = 0.0;                         // mean, of penalties [force/length^2]
  bool is_rigid = true;                         // all of it
};

SurfaceGrain grain_of(const ContactMesh& contact_mesh, SurfaceIndex surface) {
  SurfaceGrain grain;
  const auto rows = contact_mesh.rows_of(surface);
  if (rows.size() == 0) return grain;
  const auto n = static_cast<double>(rows.size());
  double log_area = 0.0;
  for (const SurfaceNodeIndex row : rows) {
    const SurfaceNode& node = contact_mesh.surface_nodes[row];
    log_area += std::log(std::max(node.area, std::numeric_limits<double>::min())) / n;
    grain.modulus += node.penalty_properties.stiffness * node.penalty_properties.thickness / n;
    grain.is_rigid = grain.is_rigid && node.penalty_properties.is_rigid;
  }
  grain.node_area = std::exp(log_area);
  return grain;
}

}  // namespace

IndexedVector<PairIndex, SurfaceIndex> find_finer_surfaces(const ContactModel& contact,
                                                           const ContactMesh& contact_mesh) {
  // So many times as stiff counts for as many times the area of a node, at most.
  constexpr double most = 9.0;
  IndexedVector<SurfaceIndex, SurfaceGrain> grains;
  for (const SurfaceIndex surface : indices(contact.surfaces.surfaces))
    grains.push_back(grain_of(contact_mesh, surface));
  IndexedVector<PairIndex, SurfaceIndex> finer;
  for (const SurfacePair& pair : contact.pairs) {
    const SurfaceGrain &first = grains[pair.first], &second = grains[pair.second];
    double stiffer = first.is_rigid ? most : 1.0 / most;  // the first one
    if (first.is_rigid == second.is_rigid)
      stiffer = second.modulus > 0.0 ? std::clamp(first.modulus / second.modulus, 1.0 / most, most) : 1.0;
    const bool is_second = pair.is_one_sided || second.node_area < stiffer * first.node_area;
    finer.push_back(is_second ? pair.second : pair.first);
  }
  return finer;
}

}  // namespace contactsim
