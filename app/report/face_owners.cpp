// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/face_owners.hpp"

#include <algorithm>
#include <iterator>

#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/simulation.hpp"

namespace contactsim {

namespace {

OwnershipRules make_rules(const ReportRegion& region, const Mesh& mesh) {
  Diagnostics found;
  auto requests = find_surface_requests(region.definition, region.region, mesh, found);
  stop_on_errors(found);
  return {std::move(requests), mesh, region.region.contact->subdomain};
}

std::vector<std::string> surface_names(std::span<const SurfaceRequest> requests) {
  std::vector<std::string> names;
  for (const SurfaceRequest& request : requests) {
    names.push_back(request.name);
    for (const SubsetRequest& subset : request.subsets) names.push_back(subset.name);
  }
  return names;
}

}  // namespace

FaceOwners::FaceOwners(const ReportRegion& region, const Mesh& mesh)
    : rules_(make_rules(region, mesh)),
      exterior_(make_skin(mesh, rules_.find_present()).exterior),
      names_(surface_names(rules_.requests())) {
  positions_.emplace(Lost{}, 0);
}

std::vector<ElementSide> FaceOwners::faces() const {
  const std::vector<ElementSide> in_sets = rules_.sides();
  std::vector<ElementSide> all;
  std::ranges::set_union(exterior_, in_sets, std::back_inserter(all));
  return all;
}

void FaceOwners::fill(const Claim& claim, ReportFace& face) {
  if (claim.owner) face.owner = claim.owner->value + 1;
  Lost lost;
  for (const Claim::Lost& one : claim.lost) lost.emplace_back(one.loser.value, one.winner.value);
  face.claims = positions_.try_emplace(std::move(lost), positions_.size()).first->second;
}

void FaceOwners::fill(bool is_lofted, ReportFace& face) {
  if (!is_lofted) {
    const ElementSide side(face.element, face.side);
    const bool is_exterior = face.shown_from > 0 || std::ranges::binary_search(exterior_, side);
    return fill(rules_.of_face(side, is_exterior), face);
  }
  LoftedClaim claim = rules_.of_lofted(face.element);
  if (!claim.body.owner) claim.body.owner = claim.owner_of_sides();
  fill(claim.body, face);
}

std::uint32_t FaceOwners::owner_of(ElementIndex element) const {
  const auto owner = rules_.of_lofted(element).body.owner;
  return owner ? owner->value + 1 : 0;
}

std::vector<FaceOwners::Lost> FaceOwners::lost() const {
  std::vector<Lost> all(positions_.size());
  for (const auto& [lost, position] : positions_) all[position] = lost;
  return all;
}

}  // namespace contactsim
