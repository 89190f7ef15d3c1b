// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>
#include <vector>

#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// Adds sets, nested assemblies and number maps to blocks of which two are 10 and 7: side sets 5 of all faces
/// at z = 1 and 6 of none, node set 100 at z = 0, node ids that descend to 1000, element ids from 500 on.
inline MeshBuilder with_sample_sets(MeshBuilder builder) {
  builder.add_side_set(5, "top", [](const CandidateSide& face) { return face.centroid.z() == 1.0; })
      .add_side_set(6, "", std::vector<ElementSide>{})
      .add_node_set(100, "fixed", [](const Eigen::Vector3d& x) { return x.z() == 0.0; });
  builder.add_assembly(1, "solids", EntityKind::block, {10, 7})
      .add_assembly(2, "sets", EntityKind::side_set, {5, 6})
      .add_assembly(3, "everything", EntityKind::assembly, {2, 1});
  const Mesh mesh = builder.build();
  std::vector<std::int64_t> node_ids(mesh.n_nodes()), element_ids(mesh.n_elements());
  std::iota(node_ids.rbegin(), node_ids.rend(), 1000);
  std::iota(element_ids.begin(), element_ids.end(), 500);
  builder.set_node_ids(node_ids).set_element_ids(element_ids);
  return builder;
}

}  // namespace contactsim::test
