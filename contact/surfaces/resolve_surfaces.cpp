// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/resolve_surfaces.hpp"

#include <fmt/format.h>

#include <map>

#include "contact/surfaces/claims.hpp"
#include "contact/surfaces/skin_faces.hpp"
#include "contact/surfaces/sort_once.hpp"
#include "contact/surfaces/surface_request.hpp"
#include "core/definition/contact.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

constexpr std::uint32_t no_owner = UINT32_MAX;

/// A face's unit normal must point nearer than this to a subset's normal. Source: Sierra/SM 5.22, 8.4.4.1.
constexpr double subset_threshold = 0.45;
/// Dot products nearer than this are a tie, which the first listed subset wins.
constexpr double subset_tie = 1e-9;

/// Gives candidates to surfaces in deck order.
class Ownership {
 public:
  Ownership(const Mesh& mesh, const ContactDomain& domain, SkinFaces skin_faces)
      : mesh_(mesh),
        domain_(domain),
        candidates_(std::move(skin_faces)),
        face_owner_(candidates_.faces.size(), no_owner),
        loft_owner_(candidates_.lofted.size(), no_owner) {}

  void add(const SurfaceRequest& request);
  std::vector<ContactSurface> take();

 private:
  void give_lofted(const SurfaceRequest& request, std::uint32_t surface);
  void give_faces(const SurfaceRequest& request, std::uint32_t surface);
  void give_nodes(const SurfaceRequest& request, std::uint32_t surface);
  std::uint32_t owner_of_shell_faces(ElementIndex element) const;
  std::uint32_t owner_of_loft(ElementIndex element) const;
  LostClaims& lost(std::uint32_t loser, std::uint32_t winner);

  const Mesh& mesh_;
  const ContactDomain& domain_;
  SkinFaces candidates_;
  std::vector<std::uint32_t> face_owner_;  ///< [n_faces] position of the owning surface
  std::vector<std::uint32_t> loft_owner_;  ///< [n_lofted]
  std::vector<std::uint32_t> node_owner_;  ///< [n_nodes] among surfaces of nodes; empty until one is made
  std::map<std::pair<std::uint32_t, std::uint32_t>, LostClaims> lost_;  ///< by loser and winner
  std::vector<ContactSurface> surfaces_;
};

LostClaims& Ownership::lost(std::uint32_t loser, std::uint32_t winner) {
  LostClaims& claims = lost_[{loser, winner}];
  claims.winner = winner;
  return claims;
}

void Ownership::add(const SurfaceRequest& request) {
  const auto surface = static_cast<std::uint32_t>(surfaces_.size());
  const auto add_surface = [&](const std::string& name, const DeckLocation& location) {
    ContactSurface& made = surfaces_.emplace_back();
    made.name = name;
    made.kind = request.kind;
    made.command = request.command;
    made.location = location;
    made.may_gain_faces = request.kind == SurfaceKind::face && !request.blocks.empty();
  };
  add_surface(request.name, request.location);
  for (const SubsetRequest& subset : request.subsets) add_surface(subset.name, subset.location);
  surfaces_[surface].analytic_planes = request.analytic_planes;
  if (request.kind == SurfaceKind::node) return give_nodes(request, surface);
  give_lofted(request, surface);
  give_faces(request, surface);
}

/// Who has a face of the shell through a side set. To contact that face and the shell's loft are one thing.
std::uint32_t Ownership::owner_of_shell_faces(ElementIndex element) const {
  for (const int side : {1, 2}) {
    const auto face = candidates_.find_face(ElementSide(element, side));
    if (face && face_owner_[*face] != no_owner) return face_owner_[*face];
  }
  return no_owner;
}

std::uint32_t Ownership::owner_of_loft(ElementIndex element) const {
  const auto loft = candidates_.find_lofted(element);
  return loft ? loft_owner_[*loft] : no_owner;
}

void Ownership::give_lofted(const SurfaceRequest& request, std::uint32_t surface) {
  for (const std::uint32_t loft : claimed_lofted(request, mesh_, candidates_)) {
    const std::uint32_t owner =
        loft_owner_[loft] != no_owner ? loft_owner_[loft] : owner_of_shell_faces(candidates_.lofted[loft]);
    if (owner == no_owner) {
      loft_owner_[loft] = surface;
    } else {
      ++lost(surface, owner).lofted;
    }
  }
}

void Ownership::give_faces(const SurfaceRequest& request, std::uint32_t surface) {
  for (const std::uint32_t face : claimed_faces(request, mesh_, candidates_)) {
    const ElementSide side = candidates_.faces[face];
    std::uint32_t owner = face_owner_[face];
    if (owner == no_owner && !candidates_.is_exterior[face]) owner = owner_of_loft(side.element());
    if (owner == surface) continue;  // the shell is lofted here already
    if (owner == no_owner) {
      face_owner_[face] = surface + choose_subset(request.subsets, mesh_, side);
    } else {
      ++lost(surface, owner).faces;
    }
  }
}

void Ownership::give_nodes(const SurfaceRequest& request, std::uint32_t surface) {
  if (node_owner_.empty()) node_owner_.assign(mesh_.n_nodes(), no_owner);
  for (const NodeIndex node : claimed_nodes(request, mesh_, domain_)) {
    std::uint32_t& owner = node_owner_[node.value];
    if (owner == no_owner) {
      owner = surface;
      surfaces_[surface].nodes.push_back(node);
    } else {
      ++lost(surface, owner).nodes;
    }
  }
}

std::vector<ContactSurface> Ownership::take() {
  for (std::size_t i = 0; i < face_owner_.size(); ++i) {
    if (face_owner_[i] != no_owner) surfaces_[face_owner_[i]].faces.push_back(candidates_.faces[i]);
  }
  for (std::size_t i = 0; i < loft_owner_.size(); ++i) {
    if (loft_owner_[i] != no_owner)
      surfaces_[loft_owner_[i]].lofted_elements.push_back(candidates_.lofted[i]);
  }
  for (const auto& [loser_and_winner, claims] : lost_)
    surfaces_[loser_and_winner.first].lost_to.push_back(claims);
  return std::move(surfaces_);
}

/// Faces between present blocks that the block forms would build from skins of single blocks.
std::uint32_t count_ignored_faces(std::span<const SurfaceRequest> requests, const SkinFaces& skin_faces) {
  std::vector<std::uint32_t> blocks;
  for (const SurfaceRequest& request : requests) {
    if (request.is_block_form) blocks.insert(blocks.end(), request.blocks.begin(), request.blocks.end());
  }
  sort_once(blocks);
  std::uint32_t n = 0;
  for (const std::uint32_t block : blocks) n += skin_faces.in_between[block];
  return n;
}

std::string list_lost(const LostClaims& lost) {
  std::string text;
  const auto add = [&](std::uint32_t n, std::string_view one, std::string_view many) {
    if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, n == 1 ? one : many);
  };
  add(lost.faces, "face", "faces");
  add(lost.lofted, "lofted element", "lofted elements");
  add(lost.nodes, "node", "nodes");
  return text;
}

void add_warnings(const ContactSurface& surface, ContactSurfaces& result) {
  for (const LostClaims& lost : surface.lost_to) {
    result.warnings.push_back({"surface-overlap", surface.location, surface.name,
                               lost.faces + lost.lofted + lost.nodes,
                               fmt::format("surface '{}': {} already in surface '{}'", surface.name,
                                           list_lost(lost), result.surfaces[lost.winner].name)});
  }
  if (!surface.is_empty()) return;
  result.warnings.push_back(
      {"surface-empty", surface.location, surface.name, 0,
       fmt::format("surface '{}' owns nothing and takes no part in contact", surface.name)});
}

void add_left_out_warning(const SurfaceRequest& request, const Mesh& mesh, ContactSurfaces& result) {
  if (request.particle_blocks_left_out.empty()) return;
  std::vector<std::string> names;
  for (const std::uint32_t block : request.particle_blocks_left_out)
    names.push_back(mesh.name({EntityKind::block, block}));
  result.warnings.push_back(
      {"surface-particles-left-out", request.location, request.name, static_cast<std::uint32_t>(names.size()),
       fmt::format("surface '{}': INCLUDE ALL BLOCKS leaves out blocks of particles only: {}", request.name,
                   fmt::join(names, ", "))});
}

}  // namespace

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

void set_surface_warnings(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                          ContactSurfaces& result) {
  result.warnings.clear();
  std::size_t surface = 0;  // a request makes one and one for each of its subsets
  for (const SurfaceRequest& request : requests) {
    add_left_out_warning(request, mesh, result);
    const std::size_t end = surface + 1 + request.subsets.size();
    for (; surface < end; ++surface) add_warnings(result.surfaces[surface], result);
  }
}

ContactSurfaces resolve_surfaces(const ContactDefinition& contact, const RegionNames& names, const Mesh& mesh,
                                 std::span<const std::uint8_t> alive, Diagnostics& diagnostics) {
  const auto requests = make_surface_requests(contact, names, mesh, diagnostics);
  const ContactDomain domain(mesh, contact.subdomain, alive);
  SkinFaces skin_faces = make_skin_faces(requests, mesh, domain);
  ContactSurfaces result;
  result.interior_faces_ignored = count_ignored_faces(requests, skin_faces);
  Ownership ownership(mesh, domain, std::move(skin_faces));
  for (const SurfaceRequest& request : requests) ownership.add(request);
  result.surfaces = ownership.take();
  set_surface_warnings(requests, mesh, result);
  return result;
}

}  // namespace contactsim
