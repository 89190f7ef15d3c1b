// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/start_overlap.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/two_cube_input.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Two cubes with contact lines, and further lines of the region.
struct CubesAtStart : TwoCubeInput {
  explicit CubesAtStart(double gap, const std::string& of_contact = "", const std::string& of_pairs = "",
                        const std::string& of_region = "")
      : TwoCubeInput(two_cube_mesh(gap).build(),
                     two_cube_deck(text_of({.region = two_cube_contact(of_contact, of_pairs) + of_region}))) {
  }
  double depth() const { return find_offset_overlaps(input())[{0}]; }
};

/// Four nodes behind one face of a diagonal of 1.
StartOverlap an_overlap(double deepest) {
  StartOverlap overlap;
  overlap.n_nodes = 4;
  overlap.n_faces = 1;
  overlap.deepest = deepest;
  overlap.node = {27};
  overlap.other = NodeIndex{18};
  overlap.size = 1.0;
  return overlap;
}

std::string told_of(const CubesAtStart& cubes, const StartOverlap& overlap,
                    const IndexedVector<PairIndex, double>& stored = {}) {
  Diagnostics warnings;
  warn_of_overlaps(cubes.input(), {&overlap, 1}, stored, warnings);
  return messages(warnings);
}

const std::string removes = "initial overlap removal = on\n";

}  // namespace

TEST_CASE("a pair is called by the names of its surfaces", "[app][overlap]") {
  const CubesAtStart cubes(0.1);
  CHECK(names_of(*cubes.contact, {0}) == "'low' and 'high'");
}

TEST_CASE("an overlap is told with nodes, depth, ids and what contact stores in it", "[app][overlap]") {
  const CubesAtStart cubes(-0.01);
  StartOverlap overlap = an_overlap(0.0125);
  CHECK_THAT(
      told_of(cubes, overlap),
      Contains("'low' and 'high' overlap at the start: 4 nodes behind 1 face or edge, deepest by 0.0125 "
               "at node 28, beside node 19 of the other side; INITIAL OVERLAP REMOVAL = ON") &&
          Contains("[overlap-at-start]"));
  CHECK_THAT(told_of(cubes, overlap, IndexedVector<PairIndex, double>{2.5}),
             Contains("of the other side; contact stores 2.5 of energy in it, which the bodies will get;"));
  CHECK_THAT(told_of(cubes, overlap, IndexedVector<PairIndex, double>{0.0}), !Contains("stores"));
  overlap.n_deep = 1;
  overlap.n_faces = 0;
  overlap.other.reset();
  CHECK_THAT(told_of(cubes, overlap),
             Contains("4 nodes behind a plane, deepest by 0.0125 at node 28; 1 node lies deeper than half an "
                      "element or sheet, where contact takes no notice;"));
}

TEST_CASE("overlaps that are round-off, tied, meant or about to be removed are not told", "[app][overlap]") {
  CHECK(told_of(CubesAtStart(-0.01), an_overlap(0.99e-4)).empty());
  CHECK_FALSE(told_of(CubesAtStart(-0.01), an_overlap(1.01e-4)).empty());
  const StartOverlap overlap = an_overlap(0.0125);
  CHECK(told_of(CubesAtStart(-0.01, removes), overlap).empty());
  CHECK(told_of(CubesAtStart(-0.01, "", "friction model = tied\n"), overlap).empty());
  CHECK(told_of(CubesAtStart(-0.01, "", "gap closure tolerance = 0.1\n"), overlap).empty());
  const CubesAtStart ignored(-0.01, "", "ignore initial overlap = on\n");
  CHECK(told_of(ignored, overlap).empty());
  StartOverlap deep = overlap;
  deep.n_deep = 2;
  CHECK_THAT(told_of(ignored, deep), Contains("2 nodes lie deeper"));
}

TEST_CASE("offsets and clearances overlap by what they leave of the gap of the mesh", "[app][overlap]") {
  CHECK(CubesAtStart(0.01).depth() == 0.0);
  CHECK(CubesAtStart(-0.01).depth() == 0.0);  // that of the mesh is told otherwise
  CHECK(CubesAtStart(0.01, "", "contact offset = 0.04\n").depth() == Approx(0.03));
  CHECK(CubesAtStart(0.01, "", "contact offset = 0.005\n").depth() == 0.0);
  CHECK(CubesAtStart(0.01, "", "initial clearance = -0.02\n").depth() == Approx(0.02));
  CHECK(CubesAtStart(0.01, "", "initial clearance = 0.02\n").depth() == 0.0);
  CHECK(CubesAtStart(0.01, "", "contact offset = 0.04\nignore initial overlap = on\n").depth() == 0.0);
  CHECK(CubesAtStart(2.0, "", "contact offset = 0.04\n").depth() == 0.0);  // nothing is near
}

TEST_CASE("what an offset has overlap is told with what contact stores in it", "[app][overlap]") {
  const CubesAtStart offset(0.01, "", "contact offset = 0.04\n"),
      clearance(0.01, "", "initial clearance = -0.02\n");
  const auto told = [](const CubesAtStart& cubes, double depth, double stored) {
    Diagnostics warnings;
    const IndexedVector<PairIndex, double> depths{depth}, energies{stored};
    warn_of_offsets(*cubes.contact, depths, energies, warnings);
    return messages(warnings);
  };
  CHECK_THAT(
      told(offset, 0.03, 0.0),
      Contains("'low' and 'high' overlap by 0.03 at the start, by their CONTACT OFFSET of 0.04; IGNORE") &&
          Contains("[offset-overlap]"));
  CHECK_THAT(told(offset, 0.03, 1.5), Contains("contact stores 1.5 of energy in it"));
  CHECK(told(offset, 0.0, 1.5).empty());
  CHECK(told(clearance, 0.02, 1.5).empty());  // that is what the deck says
}

TEST_CASE("overlap is removed where the deck asks for it, and held nodes stay", "[app][overlap]") {
  CHECK_FALSE(remove_initial_overlap(CubesAtStart(-0.02).input()));
  CHECK_FALSE(
      remove_initial_overlap(TwoCubeInput(two_cube_mesh(-0.02).build(), two_cube_deck(text_of({}))).input()));
  const bool is_held = GENERATE(false, true);
  const CubesAtStart cubes(-0.02, removes, "",
                           is_held ? "begin fixed displacement\nblock = low\ncomponents = x y z\nend\n" : "");
  auto removed = remove_initial_overlap(cubes.input());
  REQUIRE(removed);
  Diagnostics warnings;
  const auto moved = move_nodes(cubes.input(), std::move(*removed), warnings);
  REQUIRE(moved);
  CHECK(messages(warnings).empty());
  const Eigen::Matrix3Xd ways = moved->coordinates() - cubes.mesh.coordinates();
  CHECK(ways.leftCols(27).isZero(0.0) == is_held);  // of the cube low
  double top = -1.0, bottom = 9.0;
  for (Eigen::Index i = 0; i < ways.cols(); ++i) {
    const double z = moved->coordinates()(2, i);
    if (i < 27) top = std::max(top, z);
    if (i >= 27) bottom = std::min(bottom, z);
  }
  CHECK(bottom - top == Approx(0.0).margin(1e-9));
}

TEST_CASE("overlap removal that turns elements stops with the pair and the first of them", "[app][overlap]") {
  const CubesAtStart cubes(-0.02, removes);
  OverlapRemoved removed;
  removed.coordinates = cubes.mesh.coordinates();
  removed.turned = {{{3}, {0}}, {{8}, {0}}};
  Diagnostics warnings;
  CHECK_THROWS_WITH(move_nodes(cubes.input(), removed, warnings),
                    Contains("overlap removal between 'low' and 'high' would turn 2 elements inside out, the "
                             "first of them element 4 of low"));
  CHECK_THROWS_AS(move_nodes(cubes.input(), removed, warnings), SolveError);
}

TEST_CASE("overlap and gaps that are left, and nodes moved twice, are told", "[app][overlap]") {
  const CubesAtStart cubes(-0.02, removes, "gap closure tolerance = 0.1\n");
  OverlapRemoved removed;
  removed.coordinates = cubes.mesh.coordinates();
  OverlapMoves moves;
  moves.deepest = 0.02;
  moves.left = 2.1e-5;
  removed.moves = {moves};
  const auto told = [&] {
    Diagnostics warnings;
    CHECK(move_nodes(cubes.input(), removed, warnings).has_value() == (removed.moves[0].n_nodes > 0));
    return messages(warnings);
  };
  CHECK_THAT(told(), Contains("'low' and 'high' still overlap by 2.1e-05 after overlap removal") &&
                         Contains("[overlap-left]"));
  removed.moves[0].left = 1.9e-5;  // a thousandth of what there was
  CHECK(told().empty());
  removed.moves[0].widest = 0.05;
  removed.moves[0].left_open = 0.01;
  removed.moves[0].n_nodes = 5;
  CHECK_THAT(told(), Contains("a gap of 0.01 between 'low' and 'high' stays open, of 0.05") &&
                         Contains("[gap-left]"));
  removed.moves[0].left_open = 0.0;
  removed.moves[0].n_again = 1;
  CHECK_THAT(told(), Contains("1 node moved for 'low' and 'high' had been moved for an earlier pair") &&
                         Contains("[gap-closed-twice]"));
}
