// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "contact/surfaces/block_form_request.hpp"
#include "contact/surfaces/request_parts.hpp"
#include "contact/surfaces/sort_once.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

namespace {

/// Turns the commands of one contact definition into requests.
class RequestMaker {
 public:
  RequestMaker(const RegionNames& names, const Mesh& mesh, Diagnostics& diagnostics)
      : planes_(names.planes), mesh_(mesh), parts_(names, mesh, diagnostics), diagnostics_(diagnostics) {}

  void add(const ContactSurfaceLine& line) {
    auto request = make_request(line.name.text, SurfaceKind::face, "CONTACT SURFACE", line.location);
    for (const DeckName& item : line.items) add_item(item, request);
    finish(std::move(request), line.name);
  }

  void add(const ContactNodeSetLine& line) {
    static constexpr EntityKind kinds[] = {EntityKind::node_set, EntityKind::side_set, EntityKind::block,
                                           EntityKind::assembly};
    auto request = make_request(line.name.text, SurfaceKind::node, "CONTACT NODE SET", line.location);
    for (const DeckName& item : line.items) parts_.add_item(item, kinds, request);
    finish(std::move(request), line.name);
  }

  void add(const ContactSurfaceBlock& block) { finish(make_block_form_request(block, parts_), block.name); }
  void add(const SkinAllBlocks& skin);

  std::vector<SurfaceRequest> take() { return std::move(requests_); }

 private:
  void add_item(const DeckName& item, SurfaceRequest& request);
  std::optional<std::uint32_t> find_plane(const DeckName& item) const;
  void finish(SurfaceRequest request, const DeckName& name);
  void take_name(const std::string& name, const DeckLocation& location);

  std::span<const AnalyticPlane> planes_;
  const Mesh& mesh_;
  RequestParts parts_;
  Diagnostics& diagnostics_;
  std::vector<SurfaceRequest> requests_;
  std::map<std::string, DeckLocation> taken_;  ///< folded surface names
  std::map<std::uint32_t, std::pair<std::string, DeckLocation>> plane_owner_;
};

std::optional<std::uint32_t> RequestMaker::find_plane(const DeckName& item) const {
  for (std::uint32_t i = 0; i < planes_.size(); ++i) {
    if (fold(planes_[i].name.text) == fold(item.text)) return i;
  }
  return std::nullopt;
}

void RequestMaker::add_item(const DeckName& item, SurfaceRequest& request) {
  static constexpr EntityKind kinds[] = {EntityKind::side_set, EntityKind::block, EntityKind::assembly};
  const auto plane = find_plane(item);
  if (!plane) return parts_.add_item(item, kinds, request);
  if (!mesh_.find(item.text).empty()) {
    diagnostics_.add_error(item.location,
                           fmt::format("'{}' is both an analytic object and a part of the mesh", item.text),
                           "rename the analytic object", static_cast<int>(item.text.size()));
  }
  const auto [owner, is_free] = plane_owner_.try_emplace(*plane, request.name, item.location);
  if (is_free) {
    request.analytic_planes.push_back(*plane);
  } else {
    diagnostics_.add_error(
        item.location,
        fmt::format("analytic object '{}' is already in surface '{}'", item.text, owner->second.first),
        "it was claimed at " + to_string(owner->second.second), static_cast<int>(item.text.size()));
  }
}

void RequestMaker::add(const SkinAllBlocks& skin) {
  std::vector<std::uint32_t> excluded;
  for (const DeckName& item : skin.excluded) {
    for (const Entity& entity : parts_.names().find_members(item, {EntityKind::block, EntityKind::assembly},
                                                            "SKIN ALL BLOCKS EXCLUDE"))
      excluded.push_back(entity.index);
  }
  sort_once(excluded);
  for (std::uint32_t i = 0; i < mesh_.blocks().size(); ++i) {
    if (std::ranges::binary_search(excluded, i) || parts_.is_sizeless(i)) continue;
    auto request =
        make_request(mesh_.name({EntityKind::block, i}), SurfaceKind::face, "SKIN ALL BLOCKS", skin.location);
    parts_.add_block(i, skin.location, request);
    const DeckName name{request.name, skin.location};
    finish(std::move(request), name);
  }
}

void RequestMaker::take_name(const std::string& name, const DeckLocation& location) {
  const auto [first, is_free] = taken_.try_emplace(fold(name), location);
  if (is_free) return;
  diagnostics_.add_error(location, fmt::format("a second contact surface with the name '{}'", name),
                         "the first stands at " + to_string(first->second), static_cast<int>(name.size()));
}

void RequestMaker::finish(SurfaceRequest request, const DeckName& name) {
  take_name(request.name, name.location);
  for (const SubsetRequest& subset : request.subsets) take_name(subset.name, subset.location);
  sort_once(request.blocks);
  sort_once(request.side_sets);
  sort_once(request.node_sets);
  if (!requests_.empty()) request.first_surface = *requests_.back().surfaces().end();
  requests_.push_back(std::move(request));
}

}  // namespace

std::vector<SurfaceRequest> make_surface_requests(const ContactDefinition& contact, const RegionNames& names,
                                                  const Mesh& mesh, Diagnostics& diagnostics) {
  RequestMaker maker(names, mesh, diagnostics);
  for (const SurfaceCommand& command : contact.surface_commands) {
    std::visit([&](const auto& made) { maker.add(made); }, command);
  }
  return maker.take();
}

}  // namespace contactsim
