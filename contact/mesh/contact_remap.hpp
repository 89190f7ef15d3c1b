// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "contact/mesh/contact_mesh.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// The new position of each old one; none of what is removed.
template <class AnIndex>
using NewPositions = IndexedVector<AnIndex, OptionalIndex<AnIndex>>;

/// Where contact faces, surface nodes and contact nodes are after surfaces have changed, by where they were.
/// A face is the same when its element's side and its surface are, a surface node when its node and surface
/// are, an edge when its nodes are and what it is of. Faces that are still there keep their order; nodes and
/// rows do too, but for those of lofts.
struct ContactRemap {
  NewPositions<FaceIndex> faces;
  NewPositions<SurfaceNodeIndex> rows;
  NewPositions<ContactNodeIndex> nodes;
  NewPositions<EdgeIndex> edges;
  std::size_t n_faces_after = 0, n_rows_after = 0, n_nodes_after = 0, n_edges_after = 0;
};

/// Compares faces and nodes of before and after a change.
ContactRemap make_contact_remap(const ContactMesh& before, const ContactMesh& after);

/// Values of what is still there at its new position; those of what is new are `fresh`. An array that is not
/// in use, because it is empty, stays so.
template <class AnIndex, class T>
void transfer(const std::vector<OptionalIndex<AnIndex>>& positions, std::size_t n_after, const T& fresh,
              std::vector<T>& values) {
  if (values.empty()) return;
  std::vector<T> transferred(n_after, fresh);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (positions[i]) transferred[number_of(*positions[i])] = values[i];
  }
  values = std::move(transferred);
}

/// The new number of an old one, which stands for one of these positions; none if it is removed.
template <class AnIndex>
OptionalIndex<std::uint32_t> number_after(const NewPositions<AnIndex>& positions, std::uint32_t number) {
  const OptionalIndex<AnIndex> after = positions[{number}];
  return after ? OptionalIndex<std::uint32_t>(number_of(*after)) : std::nullopt;
}

/// Lists with the rows and partners that are still there.
///   rows, partners  of ContactRemap; those of the partners ascend
///   before          gets which pair each one was; [n_pairs after]
template <class Row, class Partner>
PairLists<Row, Partner> transferred(const PairLists<Row, Partner>& lists, const NewPositions<Row>& rows,
                                    const NewPositions<Partner>& partners, std::size_t n_rows_after,
                                    std::vector<std::size_t>& before) {
  std::vector<std::optional<Row>> old_rows(n_rows_after);
  for (const Row row : lists.rows()) {
    if (rows[row]) old_rows[number_of(*rows[row])] = row;
  }
  PairLists<Row, Partner> after;
  before.clear();
  for (const std::optional<Row> row : old_rows) {
    const std::size_t end = row ? lists.end_pair(*row) : 0;
    for (std::size_t k = row ? lists.first_pair(*row) : 0; k < end; ++k) {
      const OptionalIndex<Partner> partner = partners[lists.partner(k)];
      if (!partner) continue;
      after.partners.push_back(number_of(*partner));
      before.push_back(k);
    }
    after.begin.push_back(static_cast<std::uint32_t>(after.partners.size()));
  }
  return after;
}

}  // namespace contactsim
