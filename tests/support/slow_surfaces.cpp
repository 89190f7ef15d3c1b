// SPDX-License-Identifier: BSD-3-Clause
#include "support/slow_surfaces.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "contact/surfaces/ownership_rules.hpp"
#include "contact/surfaces/surface_request.hpp"
#include "contact/surfaces/surface_warnings.hpp"
#include "core/definition/contact.hpp"
#include "support/slow_skin.hpp"

namespace contactsim::test {

namespace {

class SlowSurfaces {
 public:
  SlowSurfaces(const ContactDefinition& contact, const Mesh& mesh, std::span<const std::uint8_t> alive,
               std::span<const SurfaceRequest> requests)
      : contact_(contact), mesh_(mesh), alive_(alive), skin_(make_slow_skin(mesh, find_present(requests))) {
    exterior_.insert(skin_.exterior.begin(), skin_.exterior.end());
    count_ignored_faces(requests);
    for (const SurfaceRequest& request : requests) add(request);
  }

  ContactSurfaces take();

 private:
  std::vector<std::uint8_t> find_present(std::span<const SurfaceRequest> requests) const;
  void count_ignored_faces(std::span<const SurfaceRequest> requests);
  void add(const SurfaceRequest& request);
  void claim_lofted(const SurfaceRequest& request, SurfaceIndex surface);
  void claim_faces(const SurfaceRequest& request, SurfaceIndex surface);
  void claim_nodes(const SurfaceRequest& request, SurfaceIndex surface);

  /// The living elements of some blocks.
  std::vector<ElementIndex> elements_of(const std::vector<std::uint32_t>& blocks) const;
  /// The living sides of some side sets.
  std::set<ElementSide> sides_of(const std::vector<std::uint32_t>& sets) const;
  Family family_of(ElementIndex element) const {
    return topology(mesh_.blocks()[mesh_.block_of(element)].shape).family;
  }
  /// Whether all the nodes lie within the subdomain.
  template <class Nodes>
  bool is_inside(const Nodes& nodes) const {
    return !contact_.subdomain || std::ranges::all_of(nodes, [&](NodeIndex node) {
      const Eigen::Vector3d x = mesh_.coordinates().col(node.value);
      if (const auto* box = std::get_if<ContactBox>(&contact_.subdomain->shape))
        return x.cwiseMax(box->lower).cwiseMin(box->upper) == x;
      const auto& sphere = std::get<ContactSphere>(contact_.subdomain->shape);
      return (x - sphere.point).norm() <= sphere.radius;
    });
  }

  const ContactDefinition& contact_;
  const Mesh& mesh_;
  std::span<const std::uint8_t> alive_;
  Skin skin_;
  std::set<ElementSide> exterior_;
  ContactSurfaces result_;
  std::map<ElementSide, SurfaceIndex> face_owner_;
  std::map<ElementIndex, SurfaceIndex> loft_owner_;
  std::map<NodeIndex, SurfaceIndex> node_owner_;
  std::map<std::pair<SurfaceIndex, SurfaceIndex>, LostClaims> lost_;  // by loser and winner
};

std::vector<std::uint8_t> SlowSurfaces::find_present(std::span<const SurfaceRequest> requests) const {
  std::vector<std::uint8_t> present(mesh_.n_elements(), 0);
  for (const SurfaceRequest& request : requests) {
    if (request.kind == SurfaceKind::node) continue;
    for (const ElementIndex element : elements_of(request.blocks)) present[element.value] = 1;
    for (const ElementIndex element : request.elements) present[element.value] = alive_[element.value];
  }
  return present;
}

void SlowSurfaces::count_ignored_faces(std::span<const SurfaceRequest> requests) {
  std::set<std::uint32_t> blocks;
  for (const SurfaceRequest& request : requests) {
    if (request.is_block_form) blocks.insert(request.blocks.begin(), request.blocks.end());
  }
  for (const std::uint32_t block : blocks) result_.interior_faces_ignored += skin_.in_between[block];
}

std::vector<ElementIndex> SlowSurfaces::elements_of(const std::vector<std::uint32_t>& blocks) const {
  std::vector<ElementIndex> elements;
  for (std::uint32_t i = 0; i < mesh_.n_elements(); ++i) {
    const bool is_named = std::ranges::find(blocks, mesh_.block_of({i})) != blocks.end();
    if (is_named && alive_[i] != 0) elements.push_back({i});
  }
  return elements;
}

std::set<ElementSide> SlowSurfaces::sides_of(const std::vector<std::uint32_t>& sets) const {
  std::set<ElementSide> sides;
  for (const std::uint32_t set : sets) {
    for (const ElementSide side : mesh_.side_sets()[set].sides) {
      if (alive_[side.element().value] != 0) sides.insert(side);
    }
  }
  return sides;
}

void SlowSurfaces::add(const SurfaceRequest& request) {
  const SurfaceIndex surface = result_.surfaces.next();
  const bool is_of_nodes = request.kind == SurfaceKind::node;
  ContactSurface made;
  made.name = request.name;
  made.kind = request.kind;
  made.command = request.command;
  made.location = request.location;
  made.may_gain_faces = !is_of_nodes && !request.blocks.empty();
  result_.surfaces.push_back(made);
  result_.surfaces.back().analytic_planes = request.analytic_planes;
  for (const SubsetRequest& subset : request.subsets) {
    made.name = subset.name;
    made.location = subset.location;
    result_.surfaces.push_back(made);
  }
  if (is_of_nodes) return claim_nodes(request, surface);
  claim_lofted(request, surface);
  claim_faces(request, surface);
}

void SlowSurfaces::claim_lofted(const SurfaceRequest& request, SurfaceIndex surface) {
  std::set<ElementIndex> claimed;
  for (const ElementIndex element : elements_of(request.blocks)) claimed.insert(element);
  for (const ElementIndex element : request.elements) {
    if (alive_[element.value] != 0) claimed.insert(element);
  }
  for (const ElementSide side : sides_of(request.removed_side_sets)) claimed.erase(side.element());
  for (const ElementIndex element : claimed) {
    if (family_of(element) == Family::solid || !is_inside(mesh_.element_nodes(element))) continue;
    std::optional<SurfaceIndex> owner;
    for (const int side : {2, 1}) {
      if (const auto of_side = face_owner_.find({element, side}); of_side != face_owner_.end())
        owner = of_side->second;
    }
    if (const auto of_loft = loft_owner_.find(element); of_loft != loft_owner_.end()) owner = of_loft->second;
    if (owner) {
      ++lost_[{surface, *owner}].lofted;
    } else {
      loft_owner_[element] = surface;
    }
  }
}

void SlowSurfaces::claim_faces(const SurfaceRequest& request, SurfaceIndex surface) {
  std::set<ElementSide> claimed = sides_of(request.side_sets);
  for (const ElementSide face : exterior_) {
    if (std::ranges::find(request.blocks, mesh_.block_of(face.element())) != request.blocks.end())
      claimed.insert(face);
  }
  for (const ElementSide side : sides_of(request.removed_side_sets)) claimed.erase(side);
  for (const ElementSide face : claimed) {
    if (!is_inside(mesh_.side_nodes(face))) continue;
    const auto of_face = face_owner_.find(face);
    const auto of_loft = loft_owner_.find(face.element());
    if (of_face != face_owner_.end()) {
      ++lost_[{surface, of_face->second}].faces;
    } else if (of_loft == loft_owner_.end()) {
      face_owner_[face] = {surface.value + choose_subset(request.subsets, mesh_, face)};
    } else if (of_loft->second != surface) {
      ++lost_[{surface, of_loft->second}].faces;
    }
  }
}

void SlowSurfaces::claim_nodes(const SurfaceRequest& request, SurfaceIndex surface) {
  std::set<NodeIndex> claimed;
  const auto add = [&](const auto& nodes) { claimed.insert(nodes.begin(), nodes.end()); };
  for (const std::uint32_t set : request.node_sets) add(mesh_.node_sets()[set].nodes);
  for (const ElementSide side : sides_of(request.side_sets)) add(mesh_.side_nodes(side));
  for (const ElementIndex element : elements_of(request.blocks)) add(mesh_.element_nodes(element));
  for (const NodeIndex node : claimed) {
    if (!is_inside(std::array{node})) continue;
    const auto [owner, is_free] = node_owner_.try_emplace(node, surface);
    if (!is_free) ++lost_[{surface, owner->second}].nodes;
  }
}

ContactSurfaces SlowSurfaces::take() {
  for (const auto& [face, owner] : face_owner_) result_.surfaces[owner].faces.push_back(face);
  for (const auto& [loft, owner] : loft_owner_) result_.surfaces[owner].lofted_elements.push_back(loft);
  for (const auto& [node, owner] : node_owner_) result_.surfaces[owner].nodes.push_back(node);
  for (auto& [loser_and_winner, claims] : lost_) {
    claims.winner = loser_and_winner.second;
    result_.surfaces[loser_and_winner.first].lost_to.push_back(claims);
  }
  return std::move(result_);
}

}  // namespace

ContactSurfaces resolve_slowly(const ContactDefinition& contact, const Mesh& mesh,
                               std::span<const std::uint8_t> alive) {
  Diagnostics diagnostics;
  const auto requests = make_surface_requests(contact, {}, mesh, diagnostics);
  if (diagnostics.has_errors()) throw std::logic_error("the test's deck names what its mesh has not");
  ContactSurfaces result = SlowSurfaces(contact, mesh, alive, requests).take();
  set_surface_warnings(requests, mesh, result);
  return result;
}

}  // namespace contactsim::test
