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

TEST_CASE("held nodes stay, and the gap before them is told", "[contact][gap_closure]") {
  const Mesh mesh = two_cubes(0.01);
  const std::vector<std::uint8_t> is_held(mesh.n_nodes(), 1);
  const OverlapRemoved adjusted = adjust(mesh, deck("gap closure tolerance = 0.02\n"), is_held);
  CHECK(adjusted.coordinates == mesh.coordinates());
  REQUIRE(adjusted.moves.size() == 1);
  CHECK(adjusted.moves[0].left_open == Approx(0.01));
}

TEST_CASE("only pairs that close gaps lose their overlap when removal is not asked for",
          "[contact][gap_closure]") {
  const Mesh mesh = two_cubes(-0.02);
  const std::string other =
      "contact surface low contains block_1\ncontact surface high contains block_2\n"
      "begin interaction\nsurfaces = low high\nend\n"
      "begin interaction\nsurfaces = low low\nadjust = 0.01\nend\n";
  CHECK(adjust(mesh, other).coordinates == mesh.coordinates());
}

TEST_CASE("a set that the mesh does not have is told with the nearest name", "[contact][gap_closure]") {
  const auto model = make_model(two_cubes(0.01), deck("adjust node set = lowre\n"));
  CHECK(model.messages.find("lowre") != std::string::npos);
  CHECK(model.messages.find("'lower'") != std::string::npos);
}
