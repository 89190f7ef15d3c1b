// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/deep_overlaps.hpp"

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/overlapping_bodies.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::OverlappingBodies;

namespace {

std::vector<DeepOverlap> deep_in(const OverlappingBodies& bodies, double shallow = 0.0,
                                 const std::vector<std::uint8_t>& alive = {}) {
  return DeepOverlaps(bodies.model, bodies.mesh, bodies.parts, alive)
      .find(bodies.points.coordinates(), bodies.points.renewed(), shallow);
}

/// Two blocks of unit cells; the upper one, narrower, is lowered into the lower one.
test::MeshBuilder lowered(double depth) {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 4}, .size = {4, 4, 4}});
  b.add_hexes(
      {.id = 2, .cells = {2, 2, 2}, .origin = {1, 1, 4 - depth}, .size = {2, 2, 2}, .share_nodes = false});
  return b;
}

}  // namespace

TEST_CASE("nodes inside another body are found however deep, and marked beyond half an element",
          "[contact][overlap]") {
  const double depth = GENERATE(0.3, 0.7, 1.2);
  const OverlappingBodies blocks(lowered(depth));
  const std::vector<DeepOverlap> found = deep_in(blocks);
  std::size_t n_bottom = 0;
  SurfaceNodeIndex last{0};
  for (const DeepOverlap& overlap : found) {
    CHECK_FALSE(overlap.row < last);
    last = overlap.row;
    const ContactMesh& contact_mesh = blocks.parts.contact_mesh;
    const Vector3d x = blocks.points.renewed().x(contact_mesh.surface_nodes[overlap.row].node);
    CHECK(overlap.pair == PairIndex{0});
    if (x.z() != 4.0 - depth) continue;
    ++n_bottom;
    CHECK(overlap.depth == Approx(depth));
    CHECK(overlap.normal.isApprox(Vector3d(0, 0, 1)));
    CHECK(overlap.is_deep == (depth > 0.5));
  }
  CHECK(n_bottom == 9);
}

TEST_CASE("what touches, is apart, or is of the same body lies in nothing", "[contact][overlap]") {
  CHECK(deep_in(OverlappingBodies(lowered(0.0))).empty());
  CHECK(deep_in(OverlappingBodies(lowered(-0.5))).empty());
  // Blocks that are joined by the mesh are one body.
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}});
  b.add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {1, 0, 0}});
  const OverlappingBodies joined(b);
  CHECK(deep_in(joined).empty());
  const DeepOverlaps overlaps(joined.model, joined.mesh, joined.parts);
  CHECK(std::ranges::count(overlaps.bodies(), 0u) == static_cast<std::ptrdiff_t>(joined.mesh.n_nodes()));
}

TEST_CASE("bodies in each other are found among many apart, nothing where a place is no number",
          "[contact][overlap]") {
  test::MeshBuilder b = lowered(0.7);
  for (int i = 0; i < 30; ++i)
    b.add_hexes({.id = 10 + i, .origin = {20.0 + 3.0 * i, 0, 0}, .share_nodes = false});
  const OverlappingBodies many(b);
  const std::size_t n_alone = deep_in(OverlappingBodies(lowered(0.7))).size();
  REQUIRE(n_alone > 0);
  CHECK(deep_in(many).size() == n_alone);
  const auto found_at = [&](const Eigen::Matrix3Xd& x) {
    const Mesh moved = many.mesh.with_coordinates(x);
    return DeepOverlaps(many.model, many.mesh, many.parts)
        .find(x, kinematics_of_mesh(many.parts.contact_mesh, moved))
        .size();
  };
  Eigen::Matrix3Xd x = many.mesh.coordinates();
  CHECK(found_at(x) == n_alone);
  x(1, x.cols() - 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK(found_at(x) == 0);
}

TEST_CASE("elements that are dead hold nothing", "[contact][overlap]") {
  const OverlappingBodies blocks(lowered(0.7));
  REQUIRE(deep_in(blocks).size() > 0);
  std::vector<std::uint8_t> alive(blocks.mesh.n_elements(), 1);
  CHECK(deep_in(blocks, 0.0, alive).size() == deep_in(blocks).size());
  // The middle of the top layer, where the upper block is: elements 37, 38, 41 and 42 of 64.
  const std::size_t all = deep_in(blocks).size();
  std::fill(alive.begin() + 48, alive.begin() + 64, 0);
  CHECK(deep_in(blocks, 0.0, alive).size() < all);
  std::fill(alive.begin(), alive.begin() + 64, 0);
  for (const DeepOverlap& overlap : deep_in(blocks, 0.0, alive)) {
    const ContactMesh& contact_mesh = blocks.parts.contact_mesh;
    CHECK(contact_mesh.faces[overlap.face].side.element().value >= 64);
  }
}

TEST_CASE("shallow nodes may be left out", "[contact][overlap]") {
  const OverlappingBodies blocks(lowered(0.03));
  CHECK(deep_in(blocks, 0.02).size() >= 9);
  CHECK(deep_in(blocks, 0.04).empty());
  const OverlappingBodies deeper(lowered(0.3));
  CHECK(deep_in(deeper, 0.04).size() == deep_in(deeper).size());
}

TEST_CASE("a node goes out through a face that its own surface looks at", "[contact][overlap]") {
  // A block beside a wall, 0.2 deep in it; a node of the wall is as deep in the block.
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 4}, .size = {2, 2, 4}});
  b.add_hexes(
      {.id = 2, .cells = {1, 1, 2}, .origin = {1.8, 0.5, 1.1}, .size = {1, 1, 1.9}, .share_nodes = false});
  const OverlappingBodies blocks(b);
  const std::vector<DeepOverlap> found = deep_in(blocks);
  REQUIRE(found.size() == 7);
  for (const DeepOverlap& overlap : found) {
    CHECK(overlap.depth == Approx(0.2));
    const SurfaceNode& node = blocks.parts.contact_mesh.surface_nodes[overlap.row];
    const bool is_of_wall = blocks.points.at(node.node).x() == 2.0;
    CHECK(overlap.normal.isApprox(Vector3d(is_of_wall ? -1 : 1, 0, 0)));
  }
}

TEST_CASE("inside a lofted shell only what is beyond its middle is found, the shorter way out",
          "[contact][overlap]") {
  const auto found_at = [](double height, const std::string& more = "") {
    test::MeshBuilder b;
    test::add_plate(b, {.id = 1, .u = {4, 0, 0}, .v = {0, 4, 0}}, 1.0);
    b.add_hexes({.id = 2, .origin = {1.2, 1.2, height}, .size = {1, 1, 3}, .share_nodes = false});
    return deep_in(OverlappingBodies(b, test::general_contact(more)));
  };
  CHECK(found_at(0.6).empty());
  CHECK(found_at(0.1).empty());  // 0.4 deep, less than half of the thickness
  const std::vector<DeepOverlap> found = found_at(-0.2);
  std::size_t n_corners = 0;
  for (const DeepOverlap& overlap : found) {
    CHECK(overlap.is_deep);
    if (!overlap.normal.isApprox(Vector3d(0, 0, 1))) continue;
    ++n_corners;
    CHECK(overlap.depth == Approx(0.7));
  }
  CHECK(n_corners == 4);
  // Ties leave it there.
  CHECK(found_at(-0.2, "friction model = tied\n").empty());
}

TEST_CASE("a sphere inside a solid is out once its radius is", "[contact][overlap]") {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .size = {2, 2, 2}});
  test::add_balls(b, 2, {{0.9, 1.2, 1.7}}, 0.25);
  const std::vector<DeepOverlap> found = deep_in(OverlappingBodies(b));
  REQUIRE(found.size() == 1);
  CHECK(found[0].depth == Approx(0.3 + 0.25));
  CHECK(found[0].normal.isApprox(Vector3d(0, 0, 1)));
}
