// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "contact/surfaces/item_checks.hpp"
#include "contact/surfaces/sort_once.hpp"
#include "core/definition/contact.hpp"
#include "core/mesh/name_lookup.hpp"

namespace contactsim {

namespace {

/// The list ascends.
bool contains(std::span<const std::uint32_t> list, std::uint32_t value) {
  return std::ranges::binary_search(list, value);
}

SurfaceRequest make_request(std::string name, SurfaceKind kind, std::string command,
                            const DeckLocation& location) {
  SurfaceRequest request;
  request.name = std::move(name);
  request.kind = kind;
  request.command = std::move(command);
  request.location = location;
  return request;
}

/// Turns the commands of one contact definition into requests.
class RequestMaker {
 public:
  RequestMaker(const RegionNames& names, const Mesh& mesh, Diagnostics& diagnostics)
      : planes_(names.planes),
        sizeless_(names.sizeless_blocks),
        mesh_(mesh),
        names_(mesh, names.aliases, diagnostics, "nodes go into CONTACT NODE SET"),
        diagnostics_(diagnostics) {}

  void add(const ContactSurfaceLine& line) {
    auto request = make_request(line.name.text, SurfaceKind::face, "CONTACT SURFACE", line.location);
    for (const DeckName& item : line.items) add_item(item, request);
    finish(std::move(request), line.name);
  }

  void add(const ContactNodeSetLine& line) {
    static constexpr EntityKind kinds[] = {EntityKind::node_set, EntityKind::side_set, EntityKind::block,
                                           EntityKind::assembly};
    auto request = make_request(line.name.text, SurfaceKind::node, "CONTACT NODE SET", line.location);
    for (const DeckName& item : line.items) {
      for (const Entity& entity : names_.find_members(item, kinds, request.command))
        add_entity(entity, item, request);
    }
    finish(std::move(request), line.name);
  }

  void add(const ContactSurfaceBlock& block);
  void add(const SkinAllBlocks& skin);

  std::vector<SurfaceRequest> take() { return std::move(requests_); }

 private:
  void add_item(const DeckName& item, SurfaceRequest& request);
  void add_entity(const Entity& entity, const DeckName& item, SurfaceRequest& request);
  void add_block(std::uint32_t block, const DeckLocation& location, SurfaceRequest& request);
  void add_side_set(std::uint32_t side_set, const DeckName& item, SurfaceRequest& request);
  void check_names_something(const ContactSurfaceBlock& block);
  void find_removed(const ContactSurfaceBlock& block, SurfaceRequest& request);
  void add_all_blocks(const DeckLocation& location, SurfaceRequest& request);
  void add_named_parts(const ContactSurfaceBlock& block, SurfaceRequest& request);
  void add_elements(const ContactSurfaceBlock& block, SurfaceRequest& request);
  void add_subsets(const ContactSurfaceBlock& block, SurfaceRequest& request);
  std::optional<std::uint32_t> find_plane(const DeckName& item) const;
  void finish(SurfaceRequest request, const DeckName& name);
  void take_name(const std::string& name, const DeckLocation& location);

  std::span<const AnalyticPlane> planes_;
  std::span<const std::uint32_t> sizeless_;
  const Mesh& mesh_;
  NameLookup names_;
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
  if (!plane) {
    for (const Entity& entity : names_.find_members(item, kinds, request.command))
      add_entity(entity, item, request);
    return;
  }
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

void RequestMaker::add_entity(const Entity& entity, const DeckName& item, SurfaceRequest& request) {
  switch (entity.kind) {
    case EntityKind::block:
      return add_block(entity.index, item.location, request);
    case EntityKind::side_set:
      return add_side_set(entity.index, item, request);
    case EntityKind::node_set:
      request.node_sets.push_back(entity.index);
      return;
    case EntityKind::assembly:
      return;  // find_members opened it
  }
}

void RequestMaker::add_block(std::uint32_t block, const DeckLocation& location, SurfaceRequest& request) {
  check_shape(mesh_, block, location);
  request.blocks.push_back(block);
}

void RequestMaker::add_side_set(std::uint32_t set, const DeckName& item, SurfaceRequest& request) {
  for (const ElementSide side : mesh_.side_sets()[set].sides)
    check_shape(mesh_, mesh_.block_of(side.element()), item.location);
  const bool is_usable = request.kind == SurfaceKind::node || check_faces(mesh_, set, item, diagnostics_);
  if (is_usable) request.side_sets.push_back(set);
}

void RequestMaker::add(const ContactSurfaceBlock& block) {
  auto request =
      make_request(block.name.text, SurfaceKind::face, "BEGIN CONTACT SURFACE", block.name.location);
  request.is_block_form = true;
  check_names_something(block);
  find_removed(block, request);
  if (block.includes_all_blocks) add_all_blocks(block.name.location, request);
  add_named_parts(block, request);
  add_elements(block, request);
  add_subsets(block, request);
  finish(std::move(request), block.name);
}

void RequestMaker::check_names_something(const ContactSurfaceBlock& block) {
  const bool names_something = block.includes_all_blocks || !block.blocks.empty() ||
                               !block.elements.empty() || !block.side_sets.empty() ||
                               !block.assemblies.empty();
  if (names_something) return;
  diagnostics_.add_error(
      block.name.location,
      fmt::format("contact surface '{}' names nothing that it could hold", block.name.text),
      "add a line BLOCK, ELEMENT, SURFACE, ASSEMBLY or INCLUDE ALL BLOCKS",
      static_cast<int>(block.name.text.size()));
}

void RequestMaker::find_removed(const ContactSurfaceBlock& block, SurfaceRequest& request) {
  for (const DeckName& item : block.removed_blocks) {
    const auto removed = names_.find(item, {EntityKind::block}, "REMOVE BLOCK");
    if (removed) request.removed_blocks.push_back(removed->index);
  }
  for (const DeckName& item : block.removed_side_sets) {
    const auto removed = names_.find(item, {EntityKind::side_set}, "REMOVE SURFACE");
    if (removed && check_faces(mesh_, removed->index, item, diagnostics_))
      request.removed_side_sets.push_back(removed->index);
  }
  sort_once(request.removed_blocks);
  sort_once(request.removed_side_sets);
}

void RequestMaker::add_all_blocks(const DeckLocation& location, SurfaceRequest& request) {
  for (std::uint32_t i = 0; i < mesh_.blocks().size(); ++i) {
    if (contains(request.removed_blocks, i) || contains(sizeless_, i)) continue;
    const bool is_particles = topology(mesh_.blocks()[i].shape).family == Family::particle;
    if (is_particles) {
      request.particle_blocks_left_out.push_back(i);
    } else {
      add_block(i, location, request);
    }
  }
}

void RequestMaker::add_named_parts(const ContactSurfaceBlock& block, SurfaceRequest& request) {
  const auto add_part = [&](const Entity& entity, const DeckName& item) {
    const bool is_removed =
        entity.kind == EntityKind::block && contains(request.removed_blocks, entity.index);
    const bool is_usable =
        !is_removed && check_not_particles(mesh_, entity, item, request.command, diagnostics_);
    if (is_usable) add_entity(entity, item, request);
  };
  const auto add_all = [&](const std::vector<DeckName>& items, EntityKind kind) {
    for (const DeckName& item : items) {
      for (const Entity& entity : names_.find_members(item, {kind}, request.command)) add_part(entity, item);
    }
  };
  add_all(block.blocks, EntityKind::block);
  add_all(block.side_sets, EntityKind::side_set);
  add_all(block.assemblies, EntityKind::assembly);
}

void RequestMaker::add_elements(const ContactSurfaceBlock& block, SurfaceRequest& request) {
  for (const ElementReference& reference : block.elements) {
    const int length = static_cast<int>(std::to_string(reference.id).size());
    const auto element = mesh_.find_element(reference.id);
    if (!element) {
      diagnostics_.add_error(reference.location,
                             fmt::format("the mesh has no element with id {}", reference.id), "", length);
      continue;
    }
    const std::uint32_t owner = mesh_.block_of(*element);
    const Topology& shape = topology(mesh_.blocks()[owner].shape);
    if (shape.family == Family::solid || shape.family == Family::none) {
      diagnostics_.add_error(reference.location,
                             fmt::format("element {} is a {} of block '{}'; ELEMENT picks lofted elements "
                                         "only (shells, beams, particles)",
                                         reference.id, shape.name, mesh_.name({EntityKind::block, owner})),
                             "", length);
    } else {
      request.elements.push_back(*element);
    }
  }
}

void RequestMaker::add_subsets(const ContactSurfaceBlock& block, SurfaceRequest& request) {
  for (const SurfaceSubset& subset : block.subsets) {
    request.subsets.push_back(
        {request.name + "_" + subset.name.text, subset.name.location, subset.normal.stableNormalized()});
  }
}

void RequestMaker::add(const SkinAllBlocks& skin) {
  std::vector<std::uint32_t> excluded;
  for (const DeckName& item : skin.excluded) {
    for (const Entity& entity :
         names_.find_members(item, {EntityKind::block, EntityKind::assembly}, "SKIN ALL BLOCKS EXCLUDE")) {
      excluded.push_back(entity.index);
    }
  }
  sort_once(excluded);
  for (std::uint32_t i = 0; i < mesh_.blocks().size(); ++i) {
    if (contains(excluded, i) || contains(sizeless_, i)) continue;
    auto request =
        make_request(mesh_.name({EntityKind::block, i}), SurfaceKind::face, "SKIN ALL BLOCKS", skin.location);
    add_block(i, skin.location, request);
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
  if (!requests_.empty())
    request.first_surface = requests_.back().first_surface + requests_.back().n_surfaces();
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
