// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/start_overlaps.hpp"

#include "contact/overlap/body_parting.hpp"
#include "contact/overlap/overlap_removal.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string lines =
    "skin all blocks = on\nbegin interaction defaults\n general contact = on\n self contact = on\nend\n";

/// A block of four cells a side, and a narrower one of some shape on top, lowered into it. Cells are 0.25
/// high.
MeshBuilder block_in_block(double depth, int shape, double width) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 4}});
  const double edge = 0.5 * (1.0 - width);
  const test::Box upper{.id = 2,
                        .cells = {2, 2, 4},
                        .origin = {edge, edge, 1.0 - depth},
                        .size = {width, width, 1.0},
                        .share_nodes = false};
  if (shape == 0) b.add_hexes(upper);
  if (shape == 1) b.add_tets(upper);
  if (shape == 2) b.add_wedges(upper);
  if (shape == 3) b.add_pyramids(upper);
  return b;
}

Mesh two_blocks(double depth, int shape = 0, double width = 0.5) {
  return block_in_block(depth, shape, width).build();
}

std::vector<StartOverlap> overlaps_of(const Mesh& mesh, const std::string& contact = lines) {
  return find_start_overlaps(make_model(mesh, contact), mesh, parse_contact(contact));
}

OverlapRemoved remove(const Mesh& mesh, const std::vector<std::uint8_t>& is_held = {},
                      const std::string& contact = lines) {
  return remove_overlap(make_model(mesh, contact), mesh, parse_contact(contact), is_held);
}

/// Nodes of the first block, of 5 x 5 x 5.
std::vector<std::uint8_t> hold_lower(const Mesh& mesh) {
  std::vector<std::uint8_t> is_held(mesh.n_nodes(), 0);
  std::fill_n(is_held.begin(), 125, held_fully);
  return is_held;
}

}  // namespace

TEST_CASE("overlap is found however deep, for solids of every shape", "[contact][overlap]") {
  const double depth = GENERATE(0.02, 0.1, 0.2, 0.3, 0.45);
  const int shape = GENERATE(0, 1, 2, 3);
  const auto found = overlaps_of(two_blocks(depth, shape));
  INFO(depth << " " << shape);
  REQUIRE(found.size() == 1);
  CHECK(found[0].deepest == Approx(depth).epsilon(1e-9));
  CHECK(found[0].n_nodes >= 9);
  CHECK(found[0].n_faces > 0);
  // Half of an element behind a face: its volume over the face's area is less than its height unless it is a
  // prism.
  if (depth > 0.125) CHECK(found[0].n_deep > 0);
  if (depth < 0.04) CHECK(found[0].n_deep == 0);
}

TEST_CASE("columns that stand flush are found as well", "[contact][overlap]") {
  const auto found = overlaps_of(two_blocks(0.2, 0, 1.0));
  REQUIRE(found.size() == 1);
  CHECK(found[0].deepest == Approx(0.2).epsilon(1e-9));
}

TEST_CASE("a body within another one is found", "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {8, 8, 8}});
  b.add_hexes({.id = 2, .origin = {0.6, 0.45, 0.45}, .size = {0.1, 0.1, 0.1}, .share_nodes = false});
  const auto found = overlaps_of(b.build());
  REQUIRE(found.size() == 1);
  CHECK(found[0].n_deep == 8);
  CHECK(found[0].deepest > 0.3);
}

TEST_CASE("blocks that touch, stand apart or share nodes do not overlap", "[contact][overlap]") {
  CHECK(overlaps_of(two_blocks(0.0)).empty());
  CHECK(overlaps_of(two_blocks(0.0, 1, 1.0)).empty());
  CHECK(overlaps_of(two_blocks(-0.1)).empty());
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}});
  b.add_hexes({.id = 2, .cells = {2, 2, 2}, .origin = {0, 0, 1}});
  CHECK(overlaps_of(b.build()).empty());
}

TEST_CASE("blocks that touch do not overlap by round-off, however they are turned", "[contact][overlap]") {
  const double angle = GENERATE(0.1, 0.7, 2.0);
  const double width = GENERATE(0.5, 1.0);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  MeshParts parts = block_in_block(0.0, 0, width).parts();
  parts.coordinates = turn * parts.coordinates;
  CHECK(overlaps_of(Mesh(std::move(parts))).empty());
}

TEST_CASE("a block deep in a held one goes out as a whole", "[contact][overlap]") {
  const double depth = GENERATE(0.15, 0.3, 0.45);
  const Mesh mesh = two_blocks(depth, GENERATE(0, 1, 2, 3));
  const OverlapRemoved removed = remove(mesh, hold_lower(mesh));
  CHECK(removed.turned.empty());
  const Eigen::Matrix3Xd way = removed.coordinates - mesh.coordinates();
  CHECK(way.leftCols(125).norm() == 0.0);
  CHECK((way.rightCols(way.cols() - 125).colwise() - Eigen::Vector3d(0, 0, depth)).norm() < 1e-9);
  CHECK(removed.moves.at(0).left < 1e-9);
  CHECK(removed.n_body_passes >= 1);
  CHECK(overlaps_of(mesh.with_coordinates(removed.coordinates)).empty());
}

TEST_CASE("of two free blocks each goes half the way", "[contact][overlap]") {
  const Mesh mesh = two_blocks(0.3);
  const OverlapRemoved removed = remove(mesh);
  const Eigen::Matrix3Xd way = removed.coordinates - mesh.coordinates();
  CHECK((way.leftCols(125).colwise() - Eigen::Vector3d(0, 0, -0.15)).norm() < 1e-9);
  CHECK(removed.moves.at(0).left < 1e-9);
}

TEST_CASE("overlap deeper than its tolerance stays and is reported", "[contact][overlap]") {
  const std::string more = lines + "begin remove initial overlap\n overlap normal tolerance = 0.1\nend\n";
  const Mesh mesh = two_blocks(0.3);
  const OverlapRemoved removed = remove(mesh, {}, more);
  CHECK(removed.coordinates == mesh.coordinates());
  CHECK(removed.moves.at(0).left == Approx(0.3).epsilon(1e-9));
}

TEST_CASE("removal that would turn elements inside out names them and the pair", "[contact][overlap]") {
  // The upper block is held at its far end in part, so that its surface alone may move, by more than a cell.
  const std::string more = lines + "begin remove initial overlap\n overlap normal tolerance = 1\nend\n";
  const Mesh mesh = two_blocks(0.3);
  std::vector<std::uint8_t> is_held = hold_lower(mesh);
  is_held.back() = held_in_part;
  const OverlapRemoved removed = remove(mesh, is_held, more);
  REQUIRE(!removed.turned.empty());
  CHECK(removed.turned[0].pair < PairIndex{2});
  CHECK(mesh.block_of(removed.turned[0].element) == 1);
}
