// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "app/report/report_geometry.hpp"
#include "contact/surfaces/ownership_rules.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim {

/// Who owns faces, and what was claimed in vain, by the rules of a deck.
class FaceOwners {
 public:
  /// Precondition: the region has a contact definition. Throws DeckError when its names are not those of the
  /// mesh. The mesh must outlive this.
  FaceOwners(const ReportRegion& region, const Mesh& mesh);

  /// The faces that it speaks of, ascending: exterior ones of contact's elements, and those in side sets.
  std::vector<ElementSide> faces() const;
  std::vector<std::string> names() const { return names_; }

  /// Fills in owner and claims of a face of a solid, exposed ones too; of a shell, of all of it.
  void fill(bool is_lofted, ReportFace& face);
  /// The owner of a line or particle, plus 1; 0 of none.
  std::uint32_t owner_of(ElementIndex element) const;
  /// The lists that `claims` stand for.
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> lost() const;

 private:
  using Lost = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  void fill(const Claim& claim, ReportFace& face);

  OwnershipRules rules_;
  std::vector<ElementSide> exterior_;  // ascending
  std::vector<std::string> names_;     // of surfaces
  std::map<Lost, std::uint32_t> positions_;
};

}  // namespace contactsim
