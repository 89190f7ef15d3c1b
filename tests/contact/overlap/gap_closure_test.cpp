// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/gap_closure.hpp"

#include "contact/overlap/overlap_removal.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A unit cube above another one, their edges cut into so many cells; its lower nodes are set 9, one of them
/// set 8.
Mesh two_cubes(double gap, int cells = 1) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {cells, cells, cells}});
  b.add_hexes({.id = 2, .cells = {cells, cells, cells}, .origin = {0, 0, 1.0 + gap}, .share_nodes = false});
  b.add_node_set(9, "lower", [&](const Eigen::Vector3d& x) { return x.z() == 1.0 + gap; });
  b.add_node_set(
      8, "one", [&](const Eigen::Vector3d& x) { return x.z() == 1.0 + gap && x.x() == 0.0 && x.y() == 0.0; });
  return b.build();
}

std::string deck(const std::string& lines, bool has_sides = true) {
  return "contact surface low contains block_1\ncontact surface high contains block_2\nbegin interaction\n" +
         std::string(has_sides ? "side a = low\nside b = high\n" : "surfaces = low high\n") + lines + "end\n";
}

OverlapRemoved adjust(const Mesh& mesh, const std::string& lines,
                      const std::vector<std::uint8_t>& is_held = {}) {
  const auto model = make_model(mesh, lines);
  REQUIRE(model.messages.empty());
  return remove_overlap(model, mesh, parse_contact(lines), is_held);
}

/// How many nodes of the mesh stood at a height and stand at another one now.
int n_moved(const Mesh& mesh, const OverlapRemoved& adjusted, double from, double to) {
  int n = 0;
  for (Eigen::Index i = 0; i < mesh.coordinates().cols(); ++i) {
    n += mesh.coordinates()(2, i) == from && std::abs(adjusted.coordinates(2, i) - to) < 1e-14 ? 1 : 0;
  }
  return n;
}

std::string formulation() { return GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n"); }

}  // namespace

TEST_CASE("nodes of side b go onto the other side over gaps up to the tolerance", "[contact][gap_closure]") {
  const std::string lines = deck("gap closure tolerance = 0.01\n" + formulation());
  const Mesh mesh = two_cubes(0.01);
  const OverlapRemoved adjusted = adjust(mesh, lines);
  CHECK(n_moved(mesh, adjusted, 1.0 + 0.01, 1.0) == 4);
  CHECK(n_moved(mesh, adjusted, 2.0 + 0.01, 2.0 + 0.01) == 4);
  CHECK(n_moved(mesh, adjusted, 1.0, 1.0) == 4);
  REQUIRE(adjusted.moves.size() == 1);
  CHECK(adjusted.moves[0].n_nodes == 4);
  CHECK(adjusted.moves[0].widest == Approx(0.01));
  CHECK(adjusted.moves[0].largest == Approx(0.01));
  CHECK(adjusted.moves[0].mean_square == Approx(0.01));
  CHECK(adjusted.moves[0].left_open == 0.0);
  CHECK(adjusted.volume_share == Approx(1.01));

  const Mesh wide = two_cubes(0.0101);
  CHECK(adjust(wide, lines).moves.empty());
}

TEST_CASE("without sides both go half the way", "[contact][gap_closure]") {
  const Mesh mesh = two_cubes(0.01, 2);
  const OverlapRemoved adjusted = adjust(mesh, deck("adjust = 0.02\n" + formulation(), false));
  CHECK(n_moved(mesh, adjusted, 1.0 + 0.01, 1.005) == 9);
  CHECK(n_moved(mesh, adjusted, 1.0, 1.005) == 9);
}

TEST_CASE("nodes behind the other side come out whatever the tolerance", "[contact][gap_closure]") {
  const Mesh mesh = two_cubes(-0.02);
  const OverlapRemoved adjusted = adjust(mesh, deck("gap closure tolerance = 0\n" + formulation()));
  CHECK(n_moved(mesh, adjusted, 1.0 - 0.02, 1.0) == 4);
  CHECK(n_moved(mesh, adjusted, 1.0, 1.0) == 4);
}

TEST_CASE("a node set is adjusted at any distance, and nothing else", "[contact][gap_closure]") {
  const double gap = GENERATE(0.01, 0.7, -0.02);
  const Mesh mesh = two_cubes(gap);
  const std::string set = GENERATE(as<std::string>{}, "one", "lower");
  const OverlapRemoved adjusted =
      adjust(mesh, deck("adjust node set = " + set + "\ngap closure tolerance = 1\n"));
  const int n = set == "one" ? 1 : 4;
  CHECK(n_moved(mesh, adjusted, 1.0 + gap, 1.0) == n);
  CHECK(n_moved(mesh, adjusted, 1.0 + gap, 1.0 + gap) == 4 - n);
  CHECK(n_moved(mesh, adjusted, 1.0, 1.0) == 4);
}

TEST_CASE("an automatic tolerance is a twentieth of the mean edge of the faces", "[contact][gap_closure]") {
  const double gap = GENERATE(0.0098, 0.0102);
  const Mesh mesh = two_cubes(gap, 5);
  const OverlapRemoved adjusted = adjust(mesh, deck("gap closure tolerance = AUTO\n" + formulation()));
  CHECK(n_moved(mesh, adjusted, 1.0 + gap, 1.0) == (gap < 0.01 ? 36 : 0));
}

TEST_CASE("held nodes stay, and the gap before them is reported", "[contact][gap_closure]") {
  const Mesh mesh = two_cubes(0.01);
  const std::vector<std::uint8_t> is_held(mesh.n_nodes(), 1);
  const OverlapRemoved adjusted = adjust(mesh, deck("gap closure tolerance = 0.02\n"), is_held);
  CHECK(adjusted.coordinates == mesh.coordinates());
  REQUIRE(adjusted.moves.size() == 1);
  CHECK(adjusted.moves[0].left_open == Approx(0.01));
}

TEST_CASE("only pairs that close gaps lose their overlap when removal is not asked for",
          "[contact][gap_closure]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {0, 0, 0.98}, .share_nodes = false})
                        .add_hexes({.id = 3, .origin = {9, 0, 0}})
                        .build();
  const std::string other =
      "skin all blocks = on\nbegin interaction\nsurfaces = block_1 block_2\nend\n"
      "begin interaction\nsurfaces = block_1 block_3\nadjust = 0.01\nend\n";
  CHECK(adjust(mesh, other).coordinates == mesh.coordinates());
}

TEST_CASE("a set that the mesh does not have is reported with the nearest name", "[contact][gap_closure]") {
  const auto model = make_model(two_cubes(0.01), deck("adjust node set = lowre\n"));
  CHECK(model.messages.find("lowre") != std::string::npos);
  CHECK(model.messages.find("'lower'") != std::string::npos);
}

TEST_CASE("gaps wider than SEARCH DISTANCE stay open, those of a node set are closed",
          "[contact][gap_closure]") {
  const double distance = GENERATE(0.04, 0.06);
  const Mesh mesh = two_cubes(0.05);
  const std::string reach = "search distance = " + std::to_string(distance) + "\n" + formulation();
  const OverlapRemoved near = adjust(mesh, deck("gap closure tolerance = 0.1\n" + reach));
  CHECK(n_moved(mesh, near, 1.05, 1.0) == (distance > 0.05 ? 4 : 0));
  const OverlapRemoved of_set = adjust(mesh, deck("adjust node set = lower\n" + reach));
  CHECK(n_moved(mesh, of_set, 1.05, 1.0) == 4);
}

TEST_CASE("a node that hangs over no face stays where it is", "[contact][gap_closure]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes(
      {.id = 2, .cells = {2, 1, 1}, .origin = {0.2, 0, 1.01}, .size = {2, 1, 1}, .share_nodes = false});
  const Mesh mesh = b.build();
  const OverlapRemoved adjusted = adjust(
      mesh,
      "contact surface low contains block_1\ncontact surface high contains block_2\nbegin interaction\n"
      "side a = low\nside b = high\ngap closure tolerance = 0.5\n" +
          formulation() + "end\n");
  CHECK(n_moved(mesh, adjusted, 1.01, 1.0) == 2);
  CHECK(n_moved(mesh, adjusted, 1.01, 1.01) == 4);
}

TEST_CASE("nodes move along the normal of the face that they go to", "[contact][gap_closure]") {
  // The top of the lower cube climbs by 0.2 along x; the upper one stands over it with a gap of 0.01 along
  // the normal.
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.2, 0.0, 1.0).normalized();
  MeshBuilder b;
  b.add_hexes({.id = 1, .origin = {-1, -1, 0}, .size = {3, 3, 1}});
  b.add_hexes({.id = 2, .origin = {0, 0, 1}, .share_nodes = false});
  MeshParts parts = b.parts();
  const Eigen::RowVectorXd climb = 0.2 * parts.coordinates.row(0);
  parts.coordinates.row(2) += climb;
  for (Eigen::Index i = 8; i < 16; ++i) parts.coordinates.col(i) += 0.01 * normal;
  const Mesh mesh(parts);
  const OverlapRemoved adjusted = adjust(mesh, deck("gap closure tolerance = 0.02\n" + formulation()));
  REQUIRE(adjusted.moves.size() == 1);
  CHECK(adjusted.moves[0].n_nodes == 4);
  for (Eigen::Index i = 8; i < 16; ++i) {
    const Eigen::Vector3d way = adjusted.coordinates.col(i) - mesh.coordinates().col(i);
    if (way.norm() == 0.0) continue;
    CHECK((way + 0.01 * normal).norm() < 1e-12);
  }
}

TEST_CASE("a node that two pairs move is reported, and the later pair has it", "[contact][gap_closure]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {1.0, 0, 0.005}, .share_nodes = false})
                        .add_hexes({.id = 3, .origin = {0.5, 0, 1.02}, .share_nodes = false})
                        .build();
  const auto lines = [](const std::string& first, const std::string& second) {
    const auto pair = [](const std::string& name) {
      return "begin interaction\nside a = " + name +
             "\nside b = block_3\ngap closure tolerance = 0.03\nend\n";
    };
    return "skin all blocks = on\n" + pair(first) + pair(second);
  };
  const OverlapRemoved adjusted = adjust(mesh, lines("block_1", "block_2"));
  REQUIRE(adjusted.moves.size() == 2);
  CHECK(adjusted.moves[0].n_nodes == 2);
  CHECK(adjusted.moves[1].n_nodes == 2);
  CHECK(adjusted.moves[0].n_again + adjusted.moves[1].n_again == 0);
  CHECK(n_moved(mesh, adjusted, 1.02, 1.0) == 2);
  CHECK(n_moved(mesh, adjusted, 1.02, 1.005) == 2);
  // A wall beside it has nodes of the same face.
  const Mesh corner = MeshBuilder()
                          .add_hexes({.id = 1, .origin = {0, 0, -1}, .size = {2, 1, 1}})
                          .add_hexes({.id = 2, .origin = {-1, 0, 0}, .share_nodes = false})
                          .add_hexes({.id = 3, .origin = {0.01, 0, 0.01}, .share_nodes = false})
                          .build();
  const OverlapRemoved twice = adjust(corner, lines("block_1", "block_2"));
  REQUIRE(twice.moves.size() == 2);
  CHECK(twice.moves[1].n_again == 2);
}

TEST_CASE("a surface's own gaps are not closed", "[contact][gap_closure]") {
  const Mesh mesh = two_cubes(0.01);
  const std::string line = GENERATE("gap closure tolerance = 0.02\n", "adjust node set = lower\n");
  const std::string itself = "contact surface both contains block_1 block_2\n";
  CHECK_THAT(make_model(mesh, itself + "begin interaction\nsurfaces = both\n" + line + "end\n").messages,
             Catch::Matchers::Contains("the interaction moves nodes of a surface onto itself"));
  // In defaults it is for the pairs of two surfaces.
  const std::string defaults =
      "begin interaction defaults\nself contact = on\ngeneral contact = on\n" + line + "end\n";
  CHECK(adjust(mesh, itself + defaults).moves.empty());
  CHECK(adjust(mesh, "skin all blocks = on\n" + defaults).moves.size() == 1);
}
