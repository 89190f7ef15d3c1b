// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/untied_parts.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace untied_parts_test {

namespace {

/// A bar of 10 x 1 above another one, over gaps from 0 at x = 0 to 0.6 at x = 10.
Mesh wedge() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {10, 1, 1}, .size = {10, 1, 1}});
  b.add_hexes({.id = 2, .cells = {10, 1, 1}, .origin = {0, 0, 1}, .size = {10, 1, 1}, .share_nodes = false});
  const Mesh mesh = b.build();
  Eigen::Matrix3Xd x = mesh.coordinates();
  for (Eigen::Index i = x.cols() / 2; i < x.cols(); ++i) x(2, i) += 0.06 * x(0, i);
  return mesh.with_coordinates(x);
}

UntiedPart find(const Mesh& mesh, const std::string& lines) {
  const auto model = make_model(
      mesh,
      "skin all blocks = on\nbegin interaction defaults\ngeneral contact = on\nfriction model = tied\n" +
          lines + "end\n");
  REQUIRE(model.messages.empty());
  return find_untied_parts(model, mesh, {}).at(0);
}

}  // namespace

TEST_CASE("what of a wedge no tie reaches is reported", "[contact][untied_parts]") {
  const Mesh mesh = wedge();
  const UntiedPart part = find(mesh, "capture tolerance = 0.3\n");
  CHECK(part.is_partial());
  CHECK(part.tied == Approx(5.0).margin(1.0));
  CHECK(part.tied + part.untied == Approx(10.018).epsilon(3e-3));
  CHECK(part.widest_gap > 0.5);
  REQUIRE(part.nodes.size() == 10);  // two at each x of 6, 7, .. 10
  for (const NodeIndex node : part.nodes) CHECK(mesh.coordinates()(0, node.value) > 5.5);
}

TEST_CASE("nodes of NODE_FACE that no tie reaches are reported", "[contact][untied_parts]") {
  const UntiedPart part = find(wedge(), "capture tolerance = 0.3\nconstraint formulation = node_face\n");
  CHECK(part.is_partial());
  CHECK(part.nodes.size() == 10);
  CHECK(part.tied + part.untied == Approx(10.018).epsilon(1e-2));
}

TEST_CASE("a joint that is tied as a whole leaves nothing", "[contact][untied_parts]") {
  for (const std::string& more : {std::string(), std::string("constraint formulation = node_face\n")}) {
    const UntiedPart part = find(wedge(), "capture tolerance = 1\n" + more);
    CHECK_FALSE(part.is_partial());
    CHECK(part.nodes.empty());
  }
}

TEST_CASE("what overhangs, looks away or is far is no part of a joint", "[contact][untied_parts]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
  b.add_hexes({.id = 2, .cells = {2, 2, 1}, .origin = {1, 0, 1}, .size = {2, 2, 1}, .share_nodes = false});
  const UntiedPart part = find(b.build(), "");
  CHECK(part.tied == Approx(2.0));
  CHECK_FALSE(part.is_partial());
  CHECK(part.nodes.empty());
}

}  // namespace untied_parts_test
