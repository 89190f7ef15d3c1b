// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/face_groups.hpp"

#include "core/mesh/element_faces.hpp"

namespace contactsim {

namespace {

template <class Visit>
void visit_faces_of(const Mesh& mesh, ElementIndex element, const Visit& visit) {
  element_faces::visit_faces(mesh, std::span(&element.value, 1), visit);
}

}  // namespace

void FaceGroups::find_faces(ElementIndex element, std::vector<ElementSide>& faces) const {
  faces.clear();
  visit_faces_of(mesh_, element,
                 [&](ElementSide side, const element_faces::Corners&) { faces.push_back(side); });
}

void FaceGroups::find_group(ElementSide face, std::vector<ElementSide>& group) const {
  using namespace element_faces;
  group.clear();
  FaceRecord wanted{};
  std::uint32_t node = 0;
  visit_faces_of(mesh_, face.element(), [&](ElementSide side, const Corners& corners) {
    if (side != face) return;
    wanted = make_record(corners, side);
    node = smallest(corners);
  });
  for (const ElementIndex element : elements_.of({node})) {
    visit_faces_of(mesh_, element, [&](ElementSide side, const Corners& corners) {
      if (smallest(corners) == node && make_record(corners, side).has_nodes_of(wanted)) group.push_back(side);
    });
  }
}

}  // namespace contactsim
