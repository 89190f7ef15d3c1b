// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/skin_change.hpp"

#include <algorithm>

#include "core/mesh/element_faces.hpp"

namespace contactsim {

namespace {

/// Goes through the faces of the dead and compares their groups before and after.
class SkinComparison {
 public:
  SkinComparison(const FaceGroups& faces, std::span<const std::uint8_t> present,
                 std::span<const ElementIndex> dead)
      : faces_(faces), present_(present), dead_(dead) {
    change_.in_between.assign(faces.mesh().blocks().size(), 0);
  }

  SkinChange find() {
    std::vector<ElementSide> own;
    for (const ElementIndex element : dead_) {
      if (present_[element.value] == 0) continue;
      faces_.find_faces(element, own);
      for (const ElementSide face : own) compare_group(face);
    }
    std::ranges::sort(change_.exposed);
    return std::move(change_);
  }

 private:
  /// Sets the group of a dying face before and after; returns whether the face is the first of it that dies.
  /// Each group is compared once, for that one.
  bool find_groups(ElementSide face) {
    faces_.find_group(face, before_);
    std::erase_if(before_, [&](ElementSide other) { return present_[other.element().value] == 0; });
    after_.clear();
    for (const ElementSide other : before_) {
      const bool dies = std::ranges::binary_search(dead_, other.element());
      if (dies && other < face) return false;
      if (!dies) after_.push_back(other);
    }
    return true;
  }

  void compare_group(ElementSide face) {
    if (!find_groups(face)) return;
    if (before_.size() == 1 && is_solid(face)) change_.removed.push_back(face);
    if (after_.size() == 1 && is_solid(after_.front())) change_.exposed.push_back(after_.front());
    count_in_between(before_, -1);
    count_in_between(after_, 1);
  }

  void count_in_between(std::span<const ElementSide> group, int by) {
    if (group.size() < 2) return;
    const Mesh& mesh = faces_.mesh();
    element_faces::visit_in_between(
        mesh, group, [&](ElementIndex element) { return mesh.block_of(element); },
        [&](std::uint32_t block) { change_.in_between[block] += by; });
  }

  bool is_solid(ElementSide face) const {
    const Mesh& mesh = faces_.mesh();
    return topology(mesh.blocks()[mesh.block_of(face.element())].shape).family == Family::solid;
  }

  const FaceGroups& faces_;
  std::span<const std::uint8_t> present_;
  std::span<const ElementIndex> dead_;
  SkinChange change_;
  std::vector<ElementSide> before_, after_;
};

}  // namespace

SkinChange find_skin_change(const FaceGroups& faces, std::span<const std::uint8_t> present,
                            std::span<const ElementIndex> dead) {
  return SkinComparison(faces, present, dead).find();
}

}  // namespace contactsim
