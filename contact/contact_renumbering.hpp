// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/contact_faces.hpp"

namespace contactsim {

/// Where contact faces, surface nodes and contact nodes are after surfaces have changed, by where they were.
/// A face is the same when its element's side and its surface are, a surface node when its node and surface
/// are. What is still there keeps its order.
struct ContactRenumbering {
  static constexpr std::uint32_t gone = UINT32_MAX;

  std::vector<std::uint32_t> faces, rows, nodes;  ///< [n before] position after, or gone
  std::size_t n_faces_after = 0, n_rows_after = 0, n_nodes_after = 0;
};

/// Compares faces and nodes of before and after a change.
ContactRenumbering renumber(const ContactFaces& before, const ContactFaces& after);

/// Values of what is still there at its new position; those of what is new are `fresh`. An array that is not
/// in use, because it is empty, stays so.
///   places  [n before] of ContactRenumbering
template <class T>
void carry(std::span<const std::uint32_t> places, std::size_t n_after, const T& fresh,
           std::vector<T>& values) {
  if (values.empty()) return;
  std::vector<T> carried(n_after, fresh);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (places[i] != ContactRenumbering::gone) carried[places[i]] = values[i];
  }
  values = std::move(carried);
}

/// Lists with the rows and partners that are still there; visit(place before) tells which they were, in
/// order.
template <class Visit>
PairLists carried(const PairLists& lists, std::span<const std::uint32_t> rows,
                  std::span<const std::uint32_t> partners, std::size_t n_rows_after, const Visit& visit) {
  PairLists after;
  after.begin.assign(n_rows_after + 1, 0);
  for (std::size_t row = 0; row < lists.n_rows(); ++row) {
    if (rows[row] == ContactRenumbering::gone) continue;
    for (std::size_t k = lists.begin[row]; k < lists.begin[row + 1]; ++k) {
      const std::uint32_t partner = partners[lists.partners[k]];
      if (partner == ContactRenumbering::gone) continue;
      ++after.begin[rows[row] + 1];
      after.partners.push_back(partner);
      visit(k);
    }
  }
  for (std::size_t i = 0; i < n_rows_after; ++i) after.begin[i + 1] += after.begin[i];
  return after;
}

}  // namespace contactsim
