// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/element_marks.hpp"

#include <algorithm>

namespace contactsim {

bool ElementMarks::set(const Entity& entity, bool value) {
  if (entity.kind == EntityKind::block) {
    const ElementBlock& block = mesh_.blocks()[entity.index];
    std::fill_n(is_marked_.begin() + block.first_element.value, block.n_elements, value ? 1 : 0);
    return true;
  }
  if (entity.kind != EntityKind::side_set) return false;
  for (const ElementSide side : mesh_.side_sets()[entity.index].sides) set(side.element(), value);
  return true;
}

std::vector<ElementIndex> ElementMarks::list() const {
  std::vector<ElementIndex> elements;
  for (std::uint32_t i = 0; i < is_marked_.size(); ++i) {
    if (is_marked_[i] != 0) elements.push_back({i});
  }
  return elements;
}

}  // namespace contactsim
