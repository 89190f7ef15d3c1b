// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/ownership_rules.hpp"
#include "contact/surfaces/surface_edits.hpp"
#include "core/mesh/face_groups.hpp"

namespace contactsim {

/// Contact surfaces that follow element death: resolve_surfaces() makes them while nothing is dead, and after
/// each death they are what they would be if the dead elements had never been. Looking for what changes takes
/// time proportional to what dies, taking it over time proportional to the surfaces that change.
class SurfaceTracker {
 public:
  /// `faces` must outlive this.
  ///   rules   by which the surfaces were resolved
  ///   erodes  [n_elements] 1 of elements whose nodes leave surfaces of nodes with the last of them; empty
  ///           without such elements
  SurfaceTracker(OwnershipRules rules, const FaceGroups& faces, std::vector<std::uint8_t> erodes = {});

  /// Takes deaths over into the surfaces.
  ///   dead  elements that lived so far, ascending
  SurfaceChanges update_for_deaths(std::span<const ElementIndex> dead, ContactSurfaces& surfaces);

  const OwnershipRules& rules() const { return rules_; }

 private:
  void change_faces(std::span<const ElementIndex> dead, SurfaceEdits& edits, ContactSurfaces& surfaces) const;
  void remove_lofted(ElementIndex element, SurfaceEdits& edits) const;
  bool has_eroded(NodeIndex node) const;
  Claim claim_of(NodeIndex node) const;
  std::vector<NodeIndex> nodes_of(std::span<const ElementIndex> dead) const;
  bool is_lofted(ElementIndex element) const;

  OwnershipRules rules_;
  const FaceGroups& faces_;
  std::vector<std::uint8_t> alive_, present_, erodes_;  // [n_elements]
};

}  // namespace contactsim
