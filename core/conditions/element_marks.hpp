// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Which elements of a mesh belong to something.
class ElementMarks {
 public:
  /// All elements belong, or none. The mesh must outlive this.
  ElementMarks(const Mesh& mesh, bool value) : mesh_(mesh), is_marked_(mesh.n_elements(), value ? 1 : 0) {}

  bool has(ElementIndex element) const { return is_marked_[element.value] != 0; }
  void set(ElementIndex element, bool value) { is_marked_[element.value] = value ? 1 : 0; }
  /// The elements of a block, or those that have the sides of a side set. False when the entity is neither:
  /// nothing is set then.
  bool set(const Entity& entity, bool value);

  /// Those that belong, ascending.
  std::vector<ElementIndex> list() const;

 private:
  const Mesh& mesh_;
  std::vector<std::uint8_t> is_marked_;  ///< [n_elements]
};

}  // namespace contactsim
