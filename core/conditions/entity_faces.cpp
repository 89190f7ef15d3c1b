// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/entity_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "core/conditions/entity_parts.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim {

namespace {

/// Collects the faces of the parts of one set.
class FaceFinder {
 public:
  FaceFinder(const ConditionLabel& label, const ConditionScope& scope) : label_(label), scope_(scope) {}

  void add(const NamedEntity& part);
  void remove(const Entity& entity);
  std::vector<ElementSide> take();

 private:
  void add_block(const NamedEntity& part);
  void add_shells(const NamedEntity& part);
  void add_side_set(const NamedEntity& part);
  void report(const DeckName& name, std::string text) const {
    scope_.diagnostics.add_error(name.location, std::move(text), "", static_cast<int>(name.text.size()));
  }

  const ConditionLabel& label_;
  const ConditionScope& scope_;
  std::optional<Skin> skin_;  ///< of all elements, made when a block asks for it
  std::vector<ElementSide> faces_, removed_;
  std::vector<std::uint32_t> removed_blocks_;
};

void FaceFinder::add(const NamedEntity& part) {
  switch (part.entity.kind) {
    case EntityKind::block:
      return add_block(part);
    case EntityKind::side_set:
      return add_side_set(part);
    case EntityKind::node_set:
      return report(part.name, fmt::format("{} acts on faces, which the node set '{}' does not have",
                                           label_.what, scope_.mesh.name(part.entity)));
    case EntityKind::assembly:
      return;  // find_parts opened it
  }
}

void FaceFinder::add_block(const NamedEntity& part) {
  const ElementBlock& block = scope_.mesh.blocks()[part.entity.index];
  if (topology(block.shape).family == Family::shell) return add_shells(part);
  if (!skin_) skin_ = make_skin(scope_.mesh, std::vector<std::uint8_t>(scope_.mesh.n_elements(), 1));
  const auto faces = skin_->sides_of_block(block);
  faces_.insert(faces_.end(), faces.begin(), faces.end());
}

/// Shells are loaded on the side that their normal points to.
void FaceFinder::add_shells(const NamedEntity& part) {
  const ElementBlock& block = scope_.mesh.blocks()[part.entity.index];
  const Topology& shape = topology(block.shape);
  if (shape.sides.front().kind != SideKind::face) {
    return report(part.name, fmt::format("{} acts on faces, but all sides of {} in '{}' are edges",
                                         label_.what, shape.name, scope_.mesh.name(part.entity)));
  }
  for (std::uint32_t i = 0; i < block.n_elements; ++i)
    faces_.push_back(ElementSide({block.first_element.value + i}, 1));
}

void FaceFinder::add_side_set(const NamedEntity& part) {
  for (const ElementSide side : scope_.mesh.side_sets()[part.entity.index].sides) {
    const Topology& shape = topology(scope_.mesh.blocks()[scope_.mesh.block_of(side.element())].shape);
    const bool is_face =
        !shape.sides.empty() && shape.sides[static_cast<std::size_t>(side.side() - 1)].kind == SideKind::face;
    if (!is_face) {
      return report(
          part.name,
          fmt::format("{} acts on faces, but side {} of element {} ({}) in the side set '{}' is none",
                      label_.what, side.side(), scope_.mesh.element_id(side.element()), shape.name,
                      scope_.mesh.name(part.entity)));
    }
    faces_.push_back(side);
  }
}

void FaceFinder::remove(const Entity& entity) {
  if (entity.kind == EntityKind::block) removed_blocks_.push_back(entity.index);
  if (entity.kind != EntityKind::side_set) return;
  const auto& sides = scope_.mesh.side_sets()[entity.index].sides;
  removed_.insert(removed_.end(), sides.begin(), sides.end());
}

std::vector<ElementSide> FaceFinder::take() {
  std::sort(faces_.begin(), faces_.end());
  faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  std::sort(removed_.begin(), removed_.end());
  std::erase_if(faces_, [&](ElementSide face) {
    const std::uint32_t block = scope_.mesh.block_of(face.element());
    return std::binary_search(removed_.begin(), removed_.end(), face) ||
           std::find(removed_blocks_.begin(), removed_blocks_.end(), block) != removed_blocks_.end();
  });
  return std::move(faces_);
}

/// Single nodes and elements have no faces of their own.
void check_no_ids(const EntitySet& set, const ConditionLabel& label, Diagnostics& diagnostics) {
  const auto check = [&](const std::vector<EntityId>& ids, const char* line) {
    if (ids.empty()) return;
    diagnostics.add_error(ids.front().location, fmt::format("{} takes no {} line", label.what, line),
                          "use SURFACE or BLOCK");
  };
  check(set.nodes, "NODE");
  check(set.elements, "ELEMENT");
}

}  // namespace

std::vector<ElementSide> find_faces(const EntitySet& set, const ConditionLabel& label,
                                    const ConditionScope& scope) {
  const std::size_t n_errors = scope.diagnostics.error_count();
  check_no_ids(set, label, scope.diagnostics);
  const EntityParts parts = find_parts(set, label, scope);
  FaceFinder finder(label, scope);
  for (const NamedEntity& added : parts.added) finder.add(added);
  for (const NamedEntity& removed : parts.removed) finder.remove(removed.entity);
  std::vector<ElementSide> faces = finder.take();
  if (faces.empty() && scope.diagnostics.error_count() == n_errors) {
    scope.diagnostics.add_warning("condition-empty", label.location,
                                  fmt::format("{} acts on no face", label.what));
  }
  return faces;
}

}  // namespace contactsim
