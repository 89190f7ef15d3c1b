// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/mesh/contact_mesh.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// Where contact faces, surface nodes and contact nodes are after surfaces have changed, by where they were.
/// A face is the same when its element's side and its surface are, a surface node when its node and surface
/// are, an edge when its nodes are and what it is of. Faces that are still there keep their order; nodes and
/// rows do too, but for those of lofts.
struct ContactRemap {
  std::vector<OptionalIndex<std::uint32_t>> faces, rows, nodes,
      edges;  ///< [n before] position after, none of what is gone
  std::size_t n_faces_after = 0, n_rows_after = 0, n_nodes_after = 0, n_edges_after = 0;
};

/// Compares faces and nodes of before and after a change.
ContactRemap make_contact_remap(const ContactMesh& before, const ContactMesh& after);

/// Values of what is still there at its new position; those of what is new are `fresh`. An array that is not
/// in use, because it is empty, stays so.
///   positions  [n before] of ContactRemap
template <class T>
void transfer(std::span<const OptionalIndex<std::uint32_t>> positions, std::size_t n_after, const T& fresh,
              std::vector<T>& values) {
  if (values.empty()) return;
  std::vector<T> transferred(n_after, fresh);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (positions[i]) transferred[*positions[i]] = values[i];
  }
  values = std::move(transferred);
}

/// Lists with the rows and partners that are still there.
///   rows, partners  [n before] of ContactRemap; those of the partners ascend
///   before          gets which pair each one was; [n_pairs after]
PairLists transferred(const PairLists& lists, std::span<const OptionalIndex<std::uint32_t>> rows,
                      std::span<const OptionalIndex<std::uint32_t>> partners, std::size_t n_rows_after,
                      std::vector<std::size_t>& before);

}  // namespace contactsim
