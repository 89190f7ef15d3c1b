// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "contact/surfaces/claim.hpp"
#include "contact/surfaces/contact_surface.hpp"

namespace contactsim {

/// What has changed in a surface.
struct SurfaceChange {
  std::uint32_t faces_gained = 0, faces_lost = 0;
  std::uint32_t lofted_lost = 0;                   ///< a lofted element can be lost only
  std::uint32_t nodes_gained = 0, nodes_lost = 0;  ///< of surfaces of nodes

  bool is_any() const { return faces_gained + faces_lost + lofted_lost + nodes_gained + nodes_lost > 0; }
};

using SurfaceChanges = IndexedVector<SurfaceIndex, SurfaceChange>;

/// Gathers how claims of faces, lofted elements and nodes change, each of which is reported once, and carries
/// them over into surfaces.
class SurfaceEdits {
 public:
  explicit SurfaceEdits(std::size_t n_surfaces) : edits_(n_surfaces) {}

  void change_face(ElementSide face, const Claim& before, const Claim& after);
  void change_lofted(ElementIndex element, const Claim& before, const Claim& after);
  void change_node(NodeIndex node, const Claim& before, const Claim& after);

  /// Changes what the surfaces own and have lost. Time proportional to the surfaces that change.
  SurfaceChanges apply(ContactSurfaces& surfaces);

 private:
  template <class T>
  struct Edit {
    std::vector<T> gained, lost;
  };
  struct Edits {
    Edit<ElementSide> faces;
    Edit<ElementIndex> lofted;
    Edit<NodeIndex> nodes;
  };

  template <class T>
  void change(T item, const Claim& before, const Claim& after, Edit<T> Edits::*edit,
              std::uint32_t LostClaims::*count);
  void apply_lost_claims(ContactSurfaces& surfaces) const;

  IndexedVector<SurfaceIndex, Edits> edits_;
  // By loser and winner; counts modulo 2^32, so that adding them takes away as well.
  std::map<std::pair<SurfaceIndex, SurfaceIndex>, LostClaims> lost_;
};

}  // namespace contactsim
