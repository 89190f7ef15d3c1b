// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/overlap_removal.hpp"

#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace overlap_removal_test {

namespace {

const std::string general_contact =
    "skin all blocks = on\nbegin interaction defaults\n general contact = on\n self contact = on\nend\n";

/// A unit cube and another one on top of it, lowered into it by a depth; the upper one may be smaller.
Mesh two_cubes(double depth, double upper_width = 1.0, int cells = 1) {
  MeshBuilder b;
  const double edge = 0.5 * (1.0 - upper_width);
  b.add_hexes({.id = 1, .cells = {cells, cells, 1}});
  b.add_hexes({.id = 2,
               .origin = {edge, edge, 1.0 - depth},
               .size = {upper_width, upper_width, 1.0},
               .share_nodes = false});
  b.add_node_set(9, "tips", [&](const Eigen::Vector3d& x) { return x.z() == 1.0 - depth; });
  return b.build();
}

OverlapRemoved remove(const Mesh& mesh, const std::string& lines, std::int64_t iterations = 10,
                      const std::vector<std::uint8_t>& is_held = {}) {
  const auto model = make_model(mesh, lines);
  REQUIRE(model.messages.empty());
  ContactDefinition definition = parse_contact(lines);
  definition.overlap_removal.iterations = iterations;
  return remove_overlap(model, mesh, definition, is_held);
}

/// [n_nodes] z of every node moved by overlap removal, the others NaN. Fails when a node moved sideways.
double move_at(const Mesh& mesh, const OverlapRemoved& removed, double z) {
  double way = std::numeric_limits<double>::quiet_NaN();
  for (Eigen::Index i = 0; i < mesh.coordinates().cols(); ++i) {
    const Eigen::Vector3d step = removed.coordinates.col(i) - mesh.coordinates().col(i);
    CHECK(step.head<2>().norm() == 0.0);
    if (mesh.coordinates()(2, i) != z) continue;
    if (!std::isnan(way)) CHECK(step.z() == Approx(way).margin(1e-15));
    way = step.z();
  }
  return way;
}

}  // namespace

TEST_CASE("two deformable cubes that overlap meet half way", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.02);
  const OverlapRemoved removed = remove(mesh, general_contact);
  CHECK(move_at(mesh, removed, 1.0) == Approx(-0.01).epsilon(1e-12));
  CHECK(move_at(mesh, removed, 1.0 - 0.02) == Approx(0.01).epsilon(1e-12));
  CHECK(move_at(mesh, removed, 0.0) == 0.0);
  CHECK(move_at(mesh, removed, 2.0 - 0.02) == 0.0);
  CHECK(removed.n_passes == 1);
  REQUIRE(removed.moves.size() == 1);
  CHECK(removed.moves[0].n_nodes == 8);
  CHECK(removed.moves[0].deepest == Approx(0.02).epsilon(1e-12));
  CHECK(removed.moves[0].largest == Approx(0.01).epsilon(1e-12));
  CHECK(removed.moves[0].left == 0.0);
}

TEST_CASE("out of a held cube the other one goes all the way", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.02);
  std::vector<std::uint8_t> is_held(mesh.n_nodes(), 0);
  std::fill_n(is_held.begin(), 8, std::uint8_t{1});
  const OverlapRemoved removed = remove(mesh, general_contact, 10, is_held);
  CHECK(move_at(mesh, removed, 1.0) == 0.0);
  CHECK(move_at(mesh, removed, 1.0 - 0.02) == Approx(0.02).epsilon(1e-12));
  CHECK(removed.moves.at(0).n_nodes == 4);
  is_held.assign(mesh.n_nodes(), 1);
  const OverlapRemoved stuck = remove(mesh, general_contact, 10, is_held);
  CHECK(stuck.coordinates == mesh.coordinates());
  CHECK(stuck.moves.at(0).n_nodes == 0);
  CHECK(stuck.moves.at(0).left == Approx(0.02).epsilon(1e-12));
}

TEST_CASE("out of a plane nodes go all the way", "[contact][overlap]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .origin = {0, 0, -0.02}}).build();
  const Region region = parse_region(
      "begin analytic object ground\n normal direction = 0 0 2\nend\n"
      "begin contact definition\n contact surface floor contains ground\n skin all blocks = on\n"
      " begin interaction defaults\n  general contact = on\n end\nend\n");
  const auto model = make_model(mesh, region);
  REQUIRE(model.messages.empty());
  const OverlapRemoved removed = remove_overlap(model, mesh, *region.contact, {});
  CHECK(move_at(mesh, removed, -0.02) == Approx(0.02).epsilon(1e-12));
  CHECK(move_at(mesh, removed, 1.0 - 0.02) == 0.0);
  CHECK(removed.moves.at(0).n_nodes == 4);
}

TEST_CASE("of a set of nodes and faces the nodes go all the way", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.02);
  const OverlapRemoved removed =
      remove(mesh,
             "contact surface low contains block_1\ncontact node set high contains tips\n"
             "begin interaction\n surfaces = low high\nend\n");
  CHECK(move_at(mesh, removed, 1.0) == 0.0);
  CHECK(move_at(mesh, removed, 1.0 - 0.02) == Approx(0.02).epsilon(1e-12));
}

TEST_CASE("where one side has no nodes the other one comes out alone", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.02, 0.5);
  for (const std::int64_t iterations : {1, 2, 10}) {
    const OverlapRemoved removed = remove(mesh, general_contact, iterations);
    CHECK(move_at(mesh, removed, 1.0) == 0.0);
    CHECK(move_at(mesh, removed, 1.0 - 0.02) == Approx(0.02).epsilon(1e-12));
    CHECK(removed.n_passes == iterations);
  }
}

TEST_CASE("meshes that do not match end without overlap", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.02, 0.6, 4);
  const OverlapRemoved removed = remove(mesh, general_contact);
  REQUIRE(removed.moves.size() == 1);
  CHECK(removed.moves[0].left <= 1e-6);
  CHECK(removed.moves[0].largest <= 0.02 * (1.0 + 1e-12));
}

TEST_CASE("bodies deeper in each other than half an element come apart as wholes", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.6);
  const OverlapRemoved removed = remove(mesh, general_contact);
  REQUIRE(removed.moves.size() == 1);
  CHECK(removed.moves[0].left <= 1e-9);
  const Eigen::Matrix3Xd way = removed.coordinates - mesh.coordinates();
  for (Eigen::Index i = 1; i < 8; ++i) CHECK((way.col(i) - way.col(0)).norm() < 1e-12);
  CHECK((way.col(8) - way.col(0)).norm() == Approx(0.6).epsilon(1e-9));
  const std::string reported =
      general_contact +
      "begin interaction\n surfaces = block_1 block_2\n overlap normal tolerance = 0.7\nend\n";
  CHECK(move_at(mesh, remove(mesh, reported), 1.0) == Approx(-0.3).epsilon(1e-12));
  CHECK(remove(two_cubes(0.02), general_contact + "begin interaction\n surfaces = block_1 block_2\n"
                                                  " overlap normal tolerance = 0.01\nend\n")
            .moves.empty());
}

TEST_CASE("pairs that are switched off keep their overlap", "[contact][overlap]") {
  const Mesh mesh = two_cubes(0.02);
  CHECK(remove(mesh, general_contact + "begin interaction\n surfaces = block_1 block_2\n"
                                       " interaction behavior = no_interaction\nend\n")
            .moves.empty());
}

TEST_CASE("sound bodies overlap neither themselves nor blocks that they share nodes with",
          "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 1}, .size = {1, 1, 0.05}});
  b.add_hexes({.id = 2, .cells = {2, 4, 2}, .origin = {1, 0, 0}, .size = {0.5, 1, 0.1}});
  CHECK(remove(b.build(), general_contact).moves.empty());
}

TEST_CASE("a mesh with other coordinates keeps all else", "[core][mesh]") {
  const Mesh mesh = two_cubes(0.02);
  const Eigen::Matrix3Xd coordinates = 2.0 * mesh.coordinates();
  const Mesh moved = mesh.with_coordinates(coordinates);
  CHECK(moved.coordinates() == coordinates);
  CHECK(moved.blocks().size() == mesh.blocks().size());
  CHECK(moved.find("tips") == mesh.find("tips"));
}

}  // namespace overlap_removal_test
