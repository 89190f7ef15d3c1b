// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/ownership_rules.hpp"

#include <algorithm>

#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// A face's unit normal must point nearer than this to a subset's normal. Source: Sierra/SM 5.22, 8.4.4.1.
constexpr double subset_threshold = 0.45;
/// Dot products nearer than this are a tie, which the first listed subset wins.
constexpr double subset_tie = 1e-9;

/// The side sets that requests for faces hold or remove, ascending.
std::vector<std::uint32_t> named_side_sets(std::span<const SurfaceRequest> requests) {
  std::vector<std::uint32_t> sets;
  for (const SurfaceRequest& request : requests) {
    if (request.kind == SurfaceKind::node) continue;
    sets.insert(sets.end(), request.side_sets.begin(), request.side_sets.end());
    sets.insert(sets.end(), request.removed_side_sets.begin(), request.removed_side_sets.end());
  }
  sort_once(sets);
  return sets;
}

}  // namespace

bool is_lofted(const ElementBlock& block) {
  const Family family = topology(block.shape).family;
  return family == Family::shell || family == Family::line || family == Family::particle;
}

std::uint32_t choose_subset(const std::vector<SubsetRequest>& subsets, const Mesh& mesh, ElementSide face) {
  if (subsets.empty()) return 0;
  const Eigen::Vector3d normal = area_vector(mesh, face).normalized();
  std::uint32_t best = 0;
  double best_dot = subset_threshold;
  for (std::uint32_t i = 0; i < subsets.size(); ++i) {
    const double dot = normal.dot(subsets[i].normal);
    const bool is_better = best == 0 ? dot > subset_threshold : dot > best_dot + subset_tie;
    if (!is_better) continue;
    best = i + 1;
    best_dot = dot;
  }
  return best;
}

OwnershipRules::OwnershipRules(std::vector<SurfaceRequest> requests, const Mesh& mesh,
                               const std::optional<ContactSubdomain>& subdomain)
    : requests_(std::move(requests)),
      mesh_(mesh),
      domain_(mesh, subdomain),
      of_block_(mesh.blocks().size()),
      of_set_(mesh.side_sets().size()),
      set_sides_(mesh, named_side_sets(requests_)),
      is_block_form_(mesh.blocks().size(), 0),
      nodes_(requests_, mesh, domain_) {
  for (std::uint32_t r = 0; r < requests_.size(); ++r) {
    const SurfaceRequest& request = requests_[r];
    if (request.kind == SurfaceKind::node) continue;
    for (const std::uint32_t block : request.blocks) {
      of_block_[block].push_back(r);
      if (request.is_block_form) is_block_form_[block] = 1;
    }
    for (const std::uint32_t set : request.side_sets) of_set_[set].push_back(r);
    for (const ElementIndex element : request.elements) picks_.push_back({element, r});
  }
  sort_once(picks_);
}

std::vector<std::uint8_t> OwnershipRules::find_present() const {
  std::vector<std::uint8_t> present(mesh_.n_elements(), 0);
  for (std::size_t b = 0; b < of_block_.size(); ++b) {
    const ElementBlock& block = mesh_.blocks()[b];
    const std::uint8_t is_named = of_block_[b].empty() ? 0 : 1;
    std::fill_n(present.begin() + block.first_element.value, block.n_elements, is_named);
  }
  for (const Pick& pick : picks_) present[pick.element.value] = 1;
  return present;
}

std::span<const OwnershipRules::Pick> OwnershipRules::picks_of(ElementIndex element) const {
  return std::ranges::equal_range(picks_, element, {}, &Pick::element);
}

/// Some requests together with those of picks and those that hold any of the sides, ascending, each once.
///   joined  holds the answer where it is not one of the lists that are there
std::span<const std::uint32_t> OwnershipRules::join(std::span<const std::uint32_t> some,
                                                    std::span<const Pick> picks,
                                                    std::span<const SetSide> set_sides,
                                                    Requests& joined) const {
  if (picks.empty() && set_sides.empty()) return some;
  if (picks.empty() && some.empty() && set_sides.size() == 1) return of_set_[set_sides.front().set];
  joined.assign(some.begin(), some.end());
  for (const Pick& pick : picks) joined.push_back(pick.request);
  for (const SetSide& one : set_sides)
    joined.insert(joined.end(), of_set_[one.set].begin(), of_set_[one.set].end());
  sort_once(joined);
  return joined;
}

bool OwnershipRules::is_held(std::span<const SetSide> set_sides, std::uint32_t request) const {
  return std::ranges::any_of(set_sides, [&](const SetSide& one) {
    return std::ranges::binary_search(requests_[request].side_sets, one.set);
  });
}

bool OwnershipRules::is_removed(std::span<const SetSide> set_sides, std::uint32_t request) const {
  return std::ranges::any_of(set_sides, [&](const SetSide& one) {
    return std::ranges::binary_search(requests_[request].removed_side_sets, one.set);
  });
}

void OwnershipRules::add_face(std::uint32_t request, ElementSide face, std::optional<SurfaceIndex> other,
                              Claim& claim) const {
  const SurfaceIndex surface = requests_[request].first_surface;
  const bool is_free = !claim.owner && !other;
  const std::uint32_t subset = is_free ? choose_subset(requests_[request].subsets, mesh_, face) : 0;
  claim.add(surface, {surface.value + subset}, other);
}

Claim OwnershipRules::of_face(ElementSide face, bool is_exterior) const {
  Claim claim;
  const auto set_sides = set_sides_.of(face);
  std::span<const std::uint32_t> skinning;
  if (is_exterior) skinning = of_block_[mesh_.block_of(face.element())];
  Requests joined;
  const auto requests = join(skinning, {}, set_sides, joined);
  if (requests.empty() || !domain_.holds(face)) return claim;
  for (const std::uint32_t request : requests) {
    if (!is_removed(set_sides, request)) add_face(request, face, std::nullopt, claim);
  }
  return claim;
}

/// Whether the request names the element, and neither the subdomain nor REMOVE SURFACE takes it out.
bool OwnershipRules::claims_body(std::uint32_t request, ElementIndex element) const {
  const bool is_named = std::ranges::binary_search(of_block_[mesh_.block_of(element)], request) ||
                        std::ranges::binary_search(picks_of(element), request, {}, &Pick::request);
  return is_named && domain_.holds(mesh_.element_nodes(element)) &&
         !is_removed(set_sides_.of(element), request);
}

LoftedClaim OwnershipRules::of_lofted(ElementIndex element) const {
  const auto set_sides = set_sides_.of(element);
  LoftedClaim claim;
  claim.sides = distinct_sides(set_sides);
  std::erase_if(claim.sides, [&](ElementSide side) { return !domain_.holds(side); });
  claim.of_sides.resize(claim.sides.size());
  Requests joined;
  const auto& lofting = of_block_[mesh_.block_of(element)];
  for (const std::uint32_t request : join(lofting, picks_of(element), set_sides, joined)) {
    const SurfaceIndex surface = requests_[request].first_surface;
    if (claims_body(request, element)) claim.body.add(surface, surface, claim.owner_of_sides());
    if (claim.body.owner == surface) continue;  // its sides are lofted here already
    for (std::size_t i = 0; i < claim.sides.size(); ++i) {
      const auto sets = set_sides_.of(claim.sides[i]);
      if (is_held(sets, request) && !is_removed(sets, request))
        add_face(request, claim.sides[i], claim.body.owner, claim.of_sides[i]);
    }
  }
  return claim;
}

}  // namespace contactsim
