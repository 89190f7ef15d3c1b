// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/element_marks.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Blocks of 2 and 3 hexahedra in rows; two sides of the last element and one of the first are a set.
Mesh marked_rows() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}});
  b.add_hexes({.id = 2, .cells = {3, 1, 1}, .origin = {0, 0, 5}});
  b.add_side_set(1, "", {{{4}, 2}, {{4}, 1}, {{0}, 4}});
  b.add_node_set(1, "", std::vector<std::uint32_t>{0});
  b.add_assembly(1, "", EntityKind::block, {1, 2});
  return b.build();
}

std::vector<std::uint32_t> places_of(const ElementMarks& marks) {
  std::vector<std::uint32_t> places;
  for (const ElementIndex element : marks.list()) places.push_back(element.value);
  return places;
}

using Places = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("blocks and side sets mark their elements, and take marks away", "[core][conditions]") {
  const Mesh mesh = marked_rows();
  ElementMarks marks(mesh, false);
  CHECK(places_of(marks).empty());
  CHECK(marks.set({EntityKind::block, 1}, true));
  CHECK(places_of(marks) == Places{2, 3, 4});
  CHECK(marks.set({EntityKind::side_set, 0}, false));
  CHECK(places_of(marks) == Places{2, 3});
  CHECK(marks.set({EntityKind::side_set, 0}, true));
  CHECK(places_of(marks) == Places{0, 2, 3, 4});
  marks.set(ElementIndex{3}, false);
  CHECK_FALSE(marks.has({3}));
  CHECK(marks.has({4}));
}

TEST_CASE("node sets and assemblies mark nothing and say so", "[core][conditions]") {
  const Mesh mesh = marked_rows();
  ElementMarks marks(mesh, true);
  CHECK_FALSE(marks.set({EntityKind::node_set, 0}, false));
  CHECK_FALSE(marks.set({EntityKind::assembly, 0}, false));
  CHECK(places_of(marks) == Places{0, 1, 2, 3, 4});
}
