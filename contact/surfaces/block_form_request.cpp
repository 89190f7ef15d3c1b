// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/block_form_request.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "contact/surfaces/item_checks.hpp"
#include "contact/surfaces/ownership_rules.hpp"
#include "contact/surfaces/sort_once.hpp"

namespace contactsim {

namespace {

/// Fills the request of one block form.
class BlockFormRequest {
 public:
  BlockFormRequest(const ContactSurfaceBlock& block, RequestParts& parts)
      : block_(block),
        parts_(parts),
        mesh_(parts.mesh()),
        request_(
            make_request(block.name.text, SurfaceKind::face, "BEGIN CONTACT SURFACE", block.name.location)) {
    request_.is_block_form = true;
  }

  SurfaceRequest make() {
    check_names_something();
    find_removed();
    if (block_.includes_all_blocks) add_all_blocks();
    add_named(block_.blocks, EntityKind::block);
    add_named(block_.side_sets, EntityKind::side_set);
    add_named(block_.assemblies, EntityKind::assembly);
    for (const ElementReference& reference : block_.elements) add_element(reference);
    for (const SurfaceSubset& subset : block_.subsets) {
      request_.subsets.push_back(
          {request_.name + "_" + subset.name.text, subset.name.location, subset.normal.stableNormalized()});
    }
    return std::move(request_);
  }

 private:
  void check_names_something() const;
  void find_removed();
  void add_all_blocks();
  void add_named(const std::vector<DeckName>& items, EntityKind kind);
  void add_element(const ElementReference& reference);
  bool is_removed(std::uint32_t block) const {
    return std::ranges::binary_search(request_.removed_blocks, block);
  }

  const ContactSurfaceBlock& block_;
  RequestParts& parts_;
  const Mesh& mesh_;
  SurfaceRequest request_;
};

void BlockFormRequest::check_names_something() const {
  const bool names_something = block_.includes_all_blocks || !block_.blocks.empty() ||
                               !block_.elements.empty() || !block_.side_sets.empty() ||
                               !block_.assemblies.empty();
  if (names_something) return;
  parts_.diagnostics().add_error(
      block_.name.location,
      fmt::format("contact surface '{}' names nothing that it could hold", block_.name.text),
      "add a line BLOCK, ELEMENT, SURFACE, ASSEMBLY or INCLUDE ALL BLOCKS",
      static_cast<int>(block_.name.text.size()));
}

void BlockFormRequest::find_removed() {
  for (const DeckName& item : block_.removed_blocks) {
    const auto removed = parts_.names().find(item, {EntityKind::block}, "REMOVE BLOCK");
    if (removed) request_.removed_blocks.push_back(removed->index);
  }
  for (const DeckName& item : block_.removed_side_sets) {
    const auto removed = parts_.names().find(item, {EntityKind::side_set}, "REMOVE SURFACE");
    if (removed && check_faces(mesh_, removed->index, item, parts_.diagnostics()))
      request_.removed_side_sets.push_back(removed->index);
  }
  sort_once(request_.removed_blocks);
  sort_once(request_.removed_side_sets);
}

void BlockFormRequest::add_all_blocks() {
  for (std::uint32_t i = 0; i < mesh_.blocks().size(); ++i) {
    if (is_removed(i) || parts_.is_sizeless(i)) continue;
    const bool is_particles = topology(mesh_.blocks()[i].shape).family == Family::particle;
    if (is_particles) {
      request_.particle_blocks_left_out.push_back(i);
    } else {
      parts_.add_block(i, block_.name.location, request_);
    }
  }
}

void BlockFormRequest::add_named(const std::vector<DeckName>& items, EntityKind kind) {
  for (const DeckName& item : items) {
    for (const Entity& entity : parts_.names().find_members(item, {kind}, request_.command)) {
      if (entity.kind == EntityKind::block && is_removed(entity.index)) continue;
      if (check_not_particles(mesh_, entity, item, request_.command, parts_.diagnostics()))
        parts_.add_entity(entity, item, request_);
    }
  }
}

void BlockFormRequest::add_element(const ElementReference& reference) {
  const int length = static_cast<int>(std::to_string(reference.id).size());
  const auto element = mesh_.find_element(reference.id);
  if (!element) {
    parts_.diagnostics().add_error(
        reference.location, fmt::format("the mesh has no element with id {}", reference.id), "", length);
    return;
  }
  const std::uint32_t owner = mesh_.block_of(*element);
  const Topology& shape = topology(mesh_.blocks()[owner].shape);
  if (!is_lofted(mesh_.blocks()[owner])) {
    parts_.diagnostics().add_error(
        reference.location,
        fmt::format("element {} is a {} of block '{}'; ELEMENT picks lofted elements "
                    "only (shells, beams, particles)",
                    reference.id, shape.name, mesh_.name({EntityKind::block, owner})),
        "", length);
  } else {
    request_.elements.push_back(*element);
  }
}

}  // namespace

SurfaceRequest make_block_form_request(const ContactSurfaceBlock& block, RequestParts& parts) {
  return BlockFormRequest(block, parts).make();
}

}  // namespace contactsim
