// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/interpenetration_watch.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A block of four cells a side, and a narrower one 0.1 above it. Cells are 0.25 high.
MeshBuilder two_blocks() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 4}});
  b.add_hexes({.id = 2,
               .cells = {2, 2, 4},
               .origin = {0.25, 0.25, 1.1},
               .size = {0.5, 0.5, 1.0},
               .share_nodes = false});
  return b;
}

/// A sheet, and a block of 0.2 a side 0.1 above its middle.
MeshBuilder block_over_sheet() {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, 0.02);
  b.add_hexes({.id = 2, .origin = {0.4, 0.4, 0.1}, .size = {0.2, 0.2, 0.2}, .share_nodes = false});
  return b;
}

/// Bodies that go through each other as if no contact held them.
struct Watched {
  explicit Watched(const MeshBuilder& builder, const std::string& lines = "",
                   std::span<const StartOverlap> overlaps = {})
      : bodies(builder, general_contact(lines)), watch(bodies.definition, bodies.mesh, overlaps) {
    bodies.ask();
    step(1);
  }
  void step(int n_steps) {
    if (watch.is_look_due(moment(), n_steps)) watch.look(moment());
  }
  ContactMoment moment() const {
    return {bodies.contact.kinematics(), bodies.contact.rules(), bodies.x, alive, bodies.time};
  }
  void lower(double way) {
    bodies.shift(1, {0, 0, -way});
    bodies.time += 1.0;
    bodies.ask();
  }
  const Interpenetration& found() const { return watch.all()[PairIndex{0}]; }

  ContactBodies bodies;
  std::vector<std::uint8_t> alive;
  InterpenetrationWatch watch;
};

}  // namespace

TEST_CASE("a body that has come to lie in another is seen with depth, share and node", "[contact][overlap]") {
  Watched w(two_blocks());
  w.lower(0.05);
  w.watch.look(w.moment());
  CHECK(w.found().depth == 0.0);
  w.lower(0.25);
  w.watch.look(w.moment());
  CHECK(w.found().depth == Approx(0.2));
  CHECK(w.found().share == Approx(0.8));  // of a cell
  CHECK(w.found().n_nodes == 10);         // nine of the upper block, and the middle one of the lower
  CHECK(w.found().time == 2.0);
  const double height = w.bodies.x(2, w.found().node);
  CHECK((height == Approx(0.8) || height == Approx(1.0)));
  w.lower(-0.3);  // what has been stays known
  w.watch.look(w.moment());
  CHECK(w.found().depth == Approx(0.2));
}

TEST_CASE("a look comes when a node has gone by a quarter of the thickness, at the steps for it",
          "[contact][overlap]") {
  Watched w(two_blocks());
  w.lower(0.14);
  // Seen from the mean of all nodes: of 170 the lower block has 125.
  w.step(1);
  CHECK(w.found().depth > 0.0);
  const double known = w.found().depth;
  w.lower(0.03);
  w.step(1);
  CHECK(w.found().depth == known);
  w.lower(0.2);
  for (int i = 2; i < 10; ++i) w.step(10);
  CHECK(w.found().depth == known);
  w.step(10);
  CHECK(w.found().depth > known);
}

TEST_CASE("what lay in each other at the start, what is tied and what is dead is not reported",
          "[contact][overlap]") {
  StartOverlap overlap;
  overlap.pair = {0};
  overlap.deepest = 0.15;
  const std::vector<StartOverlap> overlaps{overlap};
  Watched from_start(two_blocks(), "", overlaps);
  from_start.lower(0.3);
  from_start.watch.look(from_start.moment());
  CHECK(from_start.found().depth == Approx(0.05));

  Watched tied(two_blocks(), "friction model = tied\n");
  tied.lower(0.3);
  tied.watch.look(tied.moment());
  CHECK(tied.found().depth == 0.0);

  Watched dead(two_blocks());
  dead.alive.assign(dead.bodies.mesh.n_elements(), 0);
  dead.lower(0.3);
  dead.watch.look(dead.moment());
  CHECK(dead.found().depth == 0.0);
}

TEST_CASE("nodes that go through a sheet are counted, whichever way", "[contact][overlap]") {
  const double sign = GENERATE(1.0, -1.0);
  Watched w(block_over_sheet());
  if (sign < 0.0) {
    w.lower(0.5);
    w.watch.renumber();  // as if the block had begun below
    w.watch.look(w.moment());
  }
  w.lower(sign * 0.15);
  if (sign < 0.0) w.lower(-0.15);
  w.watch.look(w.moment());
  CHECK(w.found().n_crossed == 4);
  CHECK(std::abs(w.bodies.x(2, w.found().crossed_node)) <= 0.11);
}

TEST_CASE("what goes past the rim of a sheet goes through nothing", "[contact][overlap]") {
  Watched w(block_over_sheet());
  w.bodies.shift(1, {0.65, 0, 0});
  w.watch.look(w.moment());
  w.lower(0.4);
  w.watch.look(w.moment());
  CHECK(w.found().n_crossed == 0);
}

TEST_CASE("a watch that is restored goes on as the one that was saved", "[contact][overlap]") {
  Watched w(block_over_sheet());
  w.lower(0.05);
  StateArchive to;
  w.watch.archive(to);
  const SavedState saved = to.take();
  Watched other(block_over_sheet());
  other.lower(0.05);
  StateArchive from(saved);
  other.watch.archive(from);
  for (Watched* one : {&w, &other}) {
    one->lower(0.1);
    one->watch.look(one->moment());
  }
  CHECK(w.found().n_crossed == 4);
  CHECK(other.found().n_crossed == 4);
  CHECK(other.found().crossed_node == w.found().crossed_node);
}
