// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_warnings.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace contactsim {

namespace {

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

void set_surface_warnings(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                          ContactSurfaces& result) {
  result.warnings.clear();
  for (const SurfaceRequest& request : requests) {
    add_left_out_warning(request, mesh, result);
    for (const SurfaceIndex surface : request.surfaces()) add_warnings(result.surfaces[surface], result);
  }
}

}  // namespace contactsim
