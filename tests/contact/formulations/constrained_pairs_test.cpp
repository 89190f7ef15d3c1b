// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/constrained_pairs.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

ConstrainedPairs some_held() {
  ConstrainedPairs held;
  held.add_faces({1}, {2});
  held.add_faces({0}, {2});
  held.add_node({1}, {3});
  held.add_node({0}, {4});
  return held;
}

}  // namespace

TEST_CASE("what ties hold is held until it is removed", "[contact][constrained_pairs]") {
  ConstrainedPairs held;
  CHECK_FALSE(held.holds_faces({1}, {2}));
  CHECK(held.add_faces({1}, {2}));
  CHECK_FALSE(held.add_faces({1}, {2}));  // known already
  CHECK(held.holds_faces({1}, {2}));
  CHECK_FALSE(held.holds_faces({2}, {1}));
  CHECK_FALSE(held.holds_node({1}, {2}));  // nodes are apart from faces
  CHECK(held.add_node({1}, {2}));
  CHECK(held.holds_node({1}, {2}));
  held.remove_faces({1}, {2});
  CHECK_FALSE(held.holds_faces({1}, {2}));
  CHECK(held.holds_node({1}, {2}));
  held.remove_node({1}, {2});
  CHECK_FALSE(held.holds_node({1}, {2}));
}

TEST_CASE("after deaths what is left is held by its new number", "[contact][constrained_pairs]") {
  ConstrainedPairs held = some_held();
  ContactRemap remap;
  remap.faces = {std::nullopt, FaceIndex{0}, FaceIndex{1}};
  remap.rows = {std::nullopt, SurfaceNodeIndex{0}};
  held.remap(remap);
  CHECK(held.holds_faces({0}, {1}));
  CHECK_FALSE(held.holds_faces({1}, {2}));
  CHECK_FALSE(held.holds_faces({0}, {2}));
  CHECK(held.holds_node({0}, {3}));  // pairs of surfaces stay
  CHECK_FALSE(held.holds_node({0}, {4}));
  CHECK_FALSE(held.holds_node({1}, {3}));
}

TEST_CASE("what is held goes on from a stored state", "[contact][constrained_pairs]") {
  ConstrainedPairs held = some_held(), other;
  StateArchive saves;
  held.archive(saves);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  other.archive(restores);
  CHECK(other.holds_faces({1}, {2}));
  CHECK(other.holds_faces({0}, {2}));
  CHECK(other.holds_node({1}, {3}));
  CHECK_FALSE(other.holds_node({2}, {3}));
}
