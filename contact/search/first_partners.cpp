// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/first_partners.hpp"

#include <algorithm>
#include <vector>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

template <class AnIndex>
bool is_marked(const IndexedVector<AnIndex, std::uint8_t>& marks, AnIndex i) {
  return !marks.empty() && marks[i] != 0;
}

SurfaceIndex surface_of(const ContactMesh& contact_mesh, FaceIndex face) {
  return contact_mesh.faces[face].surface;
}
SurfaceIndex surface_of(const ContactMesh& contact_mesh, SurfaceNodeIndex row) {
  return contact_mesh.surface_nodes[row].surface;
}

/// Which candidates of a later search stay.
template <class Row>
struct Restriction {
  const ContactMesh& contact_mesh;
  const PairRules& rules;
  const PairLists<Row, FaceIndex>& first;
  const IndexedVector<Row, std::uint8_t>& is_free_row;
  const IndexedVector<FaceIndex, std::uint8_t>& is_free_face;

  bool keeps(Row row, FaceIndex partner) const {
    const auto pair = rules.find(surface_of(contact_mesh, row), surface_of(contact_mesh, partner));
    return rules[*pair].pair->behavior != InteractionBehavior::infinitesimal_sliding ||
           is_marked(is_free_row, row) || is_marked(is_free_face, partner) ||
           std::ranges::binary_search(first.of(row), partner);
  }
  void apply(PairLists<Row, FaceIndex>& lists) const {
    std::uint32_t n = 0, begin = 0;
    for (const Row row : lists.rows()) {
      const std::uint32_t end = lists.begin[row.value + 1];
      for (std::uint32_t k = begin; k < end; ++k) {
        const FaceIndex partner = lists.partner(k);
        if (keeps(row, partner)) lists.partners[n++] = partner.value;
      }
      begin = end;
      lists.begin[row.value + 1] = n;
    }
    lists.partners.resize(n);
  }
};

/// Marks what was not there before besides what is marked already.
///   marks  [n before], or empty when nothing was; gets [n_after]
template <class AnIndex>
void mark_new(const NewPositions<AnIndex>& positions, std::size_t n_after,
              IndexedVector<AnIndex, std::uint8_t>& marks) {
  marks.resize(positions.size(), 0);
  IndexedVector<AnIndex, std::uint8_t> after(n_after, 1);
  for (const AnIndex i : indices(positions)) {
    if (positions[i]) after[*positions[i]] = marks[i];
  }
  marks = std::move(after);
}

template <class Row>
bool has_pair(const PairLists<Row, FaceIndex>& lists, PairIndex pair, const ContactMesh& contact_mesh,
              const PairRules& rules) {
  for (const Row row : lists.rows()) {
    for (const FaceIndex partner : lists.of(row)) {
      if (rules.find(surface_of(contact_mesh, row), surface_of(contact_mesh, partner)) == pair) return true;
    }
  }
  return false;
}

}  // namespace

void FirstPartners::restrict(const ContactMesh& contact_mesh, const PairRules& rules,
                             FacePairLists& lists) const {
  Restriction<FaceIndex>{contact_mesh, rules, face_pairs_, is_free_face_, is_free_face_}.apply(lists);
}

void FirstPartners::restrict(const ContactMesh& contact_mesh, const PairRules& rules,
                             NodeFaceLists& lists) const {
  Restriction<SurfaceNodeIndex>{contact_mesh, rules, node_faces_, is_free_row_, is_free_face_}.apply(lists);
}

bool FirstPartners::has_any(PairIndex pair, const ContactMesh& contact_mesh, const PairRules& rules) const {
  return has_pair(face_pairs_, pair, contact_mesh, rules) || has_pair(node_faces_, pair, contact_mesh, rules);
}

void FirstPartners::remap(const ContactRemap& remap, bool releases_new) {
  std::vector<std::size_t> before;
  face_pairs_ = transferred(face_pairs_, remap.faces, remap.faces, remap.n_faces_after, before);
  node_faces_ = transferred(node_faces_, remap.rows, remap.faces, remap.n_rows_after, before);
  if (!releases_new) return;
  mark_new(remap.faces, remap.n_faces_after, is_free_face_);
  mark_new(remap.rows, remap.n_rows_after, is_free_row_);
}

void FirstPartners::archive(StateArchive& saved) {
  contactsim::archive("contact/search/first_face_pairs", face_pairs_, saved);
  contactsim::archive("contact/search/first_node_pairs", node_faces_, saved);
  // Most runs have released nothing, and states of such runs hold nothing of it.
  const bool has_free = saved.restores() ? saved.has("contact/search/new_faces")
                                         : !is_free_face_.empty() || !is_free_row_.empty();
  if (!has_free) {
    is_free_face_.clear();
    is_free_row_.clear();
    return;
  }
  saved.list("contact/search/new_faces", is_free_face_);
  saved.list("contact/search/new_nodes", is_free_row_);
}

}  // namespace contactsim
