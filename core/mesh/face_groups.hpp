// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/node_elements.hpp"

namespace contactsim {

/// Faces as a skin sees them (core/mesh/skin.hpp), one element at a time: all sides of solids, side 1 of
/// shells.
class FaceGroups {
 public:
  /// Both must outlive this.
  FaceGroups(const Mesh& mesh, const NodeElements& elements) : mesh_(mesh), elements_(elements) {}

  /// Sets the faces of an element, in order of their sides.
  void find_faces(ElementIndex element, std::vector<ElementSide>& faces) const;
  /// Sets all faces with the same corner nodes as one, itself among them, in order of their elements.
  /// Precondition: the face is one that find_faces tells.
  void find_group(ElementSide face, std::vector<ElementSide>& group) const;

  const Mesh& mesh() const { return mesh_; }
  const NodeElements& elements() const { return elements_; }

 private:
  const Mesh& mesh_;
  const NodeElements& elements_;
};

}  // namespace contactsim
