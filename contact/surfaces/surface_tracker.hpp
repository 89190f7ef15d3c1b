// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/ownership_rules.hpp"
#include "core/mesh/face_groups.hpp"

namespace contactsim {

/// What deaths have changed in a surface.
struct SurfaceChange {
  std::uint32_t faces_gained = 0, faces_lost = 0;
  std::uint32_t lofted_lost = 0;                   ///< a lofted element can be lost only
  std::uint32_t nodes_gained = 0, nodes_lost = 0;  ///< of surfaces of nodes

  bool is_any() const { return faces_gained + faces_lost + lofted_lost + nodes_gained + nodes_lost > 0; }
};

/// Contact surfaces that follow element death: after each death they are what resolve_surfaces() would make
/// of the living elements. Looking for what changes takes time proportional to what dies, taking it over time
/// proportional to the surfaces that change.
class SurfaceTracker {
 public:
  /// All that is referred to must outlive this.
  ///   rules     their requests made the surfaces
  ///   alive     [n_elements] 0 or 1, by which the surfaces were resolved
  ///   erodes    [n_elements] 1 of elements whose nodes leave surfaces of nodes with the last of them; empty
  ///             without such elements
  SurfaceTracker(OwnershipRules rules, const FaceGroups& faces, std::span<const std::uint8_t> alive,
                 const ContactSurfaces& surfaces, std::vector<std::uint8_t> erodes = {});

  /// Takes deaths over into the surfaces. Returns [n_surfaces].
  ///   dead  elements that lived so far, ascending
  std::vector<SurfaceChange> update_for_deaths(std::span<const ElementIndex> dead, ContactSurfaces& surfaces);

  const OwnershipRules& rules() const { return rules_; }

 private:
  /// What comes and goes in one surface.
  struct Edit {
    std::vector<ElementSide> gained, lost;
    std::vector<ElementIndex> lofted_lost;
    std::vector<NodeIndex> nodes_gained, nodes_lost;
  };
  enum class Kind : std::uint8_t { face, lofted, node };

  void update_group(ElementSide face, ContactSurfaces& surfaces);
  void update_sides(ElementIndex element);
  void update_lofted(ElementIndex element);
  void update_nodes(std::span<const ElementIndex> dead, std::span<const std::uint8_t> alive_before);
  bool has_eroded(NodeIndex node) const;
  void change_face(ElementSide face, const Claim& before, const Claim& after);
  void count(const Claim& claim, Kind kind, int by);
  std::uint32_t count_in_between(std::span<const ElementSide> group, bool is_after) const;
  bool is_present(ElementIndex element, bool is_after) const {
    return present_[element.value] != 0 && !(is_after && dies_[element.value] != 0);
  }
  bool is_solid(ElementIndex element) const;
  std::vector<SurfaceChange> apply(ContactSurfaces& surfaces);

  OwnershipRules rules_;
  const FaceGroups& faces_;
  std::vector<std::uint8_t> alive_, present_, erodes_;                  // [n_elements]
  std::vector<std::uint8_t> dies_;                                      // [n_elements] now
  std::map<std::pair<std::uint32_t, std::uint32_t>, LostClaims> lost_;  // by loser and winner
  std::vector<Edit> edits_;                                             // [n_surfaces]
  std::vector<ElementSide> group_;                                      // scratch
};

}  // namespace contactsim
