// SPDX-License-Identifier: BSD-3-Clause
// CAPTURE TOLERANCE, SEARCH DISTANCE and INFINITESIMAL_SLIDING, as ties and forces.
#include "contact/enforcement/contact_force.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/lofted_meshes.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace contact_force_reach_test {

namespace {

const std::string stiff = "penalty stiffness = 1e4\n", tied = "friction model = tied\n",
                  small = "interaction behavior = infinitesimal_sliding\n";

/// Moves the upper body in many steps.
void move(ContactBodies& bodies, const Vector3d& way, int n_steps = 200) {
  bodies.set_velocity(1, way / n_steps);
  for (int i = 0; i < n_steps; ++i) bodies.step(1.0);
  bodies.set_velocity(1, Vector3d::Zero());
}

double tied_area(const ContactBodies& bodies) {
  double sum = 0.0;
  for (const Tie& tie : bodies.contact.ties()) sum += tie.area;
  return sum;
}

/// Four faces in a row, and a cube over the first of them, which it presses on by 0.01.
MeshBuilder cube_on_row(double turned = 0.0) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 1, 1}, .size = {1, 0.25, 0.25}});
  b.add_hexes({.id = 2, .origin = {0, turned, 0.24}, .size = {0.25, 0.25, 0.25}, .share_nodes = false});
  return b;
}

constexpr double press_on_row = 1e4 * 0.01 * 0.0625;

}  // namespace

TEST_CASE("a tie reaches as far as CAPTURE TOLERANCE says", "[contact][contact_force][reach]") {
  ContactBodies near(stacked_cubes(0.31), general_contact(tied + "capture tolerance = 0.35\n"));
  near.ask();
  CHECK(near.contact.ties().size() == 1);
  CHECK(tied_area(near) == Approx(1.0));
  ContactBodies far(stacked_cubes(0.31), general_contact(tied + "capture tolerance = 0.30\n"));
  far.ask();
  CHECK(far.contact.ties().empty());
}

TEST_CASE("a wedge is tied as far as CAPTURE TOLERANCE says", "[contact][contact_force][reach]") {
  const auto [tolerance, area, margin] =
      GENERATE(table<double, double, double>({{1.0, 10.018, 0.03}, {0.3, 5.0, 1.0}}));
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {10, 1, 1}, .size = {10, 1, 1}});
  b.add_hexes({.id = 2, .cells = {10, 1, 1}, .origin = {0, 0, 1}, .size = {10, 1, 1}, .share_nodes = false});
  ContactBodies bodies(b, general_contact(tied + fmt::format("capture tolerance = {}\n", tolerance)));
  const Eigen::RowVectorXd up = 0.06 * bodies.x.row(0);
  for (Eigen::Index i = bodies.x.cols() / 2; i < bodies.x.cols(); ++i) bodies.x(2, i) += up[i];
  bodies.ask();
  CHECK(tied_area(bodies) == Approx(area).margin(margin));
}

TEST_CASE("only the first search reaches for ties", "[contact][contact_force][reach]") {
  // The cubes part; an overhang of contact would be a candidate at every later search.
  ContactBodies bodies(stacked_cubes(0.4, 2), general_contact("capture tolerance = 0.5\n" + stiff));
  bodies.ask();
  CHECK(bodies.contact.n_candidates() == 0);
}

TEST_CASE("SEARCH DISTANCE leaves out what is farther at the start", "[contact][contact_force][reach]") {
  const auto [line, gap, is_found] = GENERATE(table<std::string, double, bool>({
      {"auto", 1.9 * 0.25, true},
      {"auto", 2.1 * 0.25, false},
      {"0.2", 0.19, true},
      {"0.2", 0.21, false},
  }));
  const std::string more = "search distance = " + line + "\n" + stiff + formulation();
  ContactBodies bodies(stacked_cubes(gap, 4), general_contact(more));
  bodies.ask();
  move(bodies, {0, 0, -gap - 0.01});
  CHECK(lift(bodies) == Approx(is_found ? 100.0 : 0.0).epsilon(0.03));
  CHECK(bodies.net_force().norm() < 1e-9);
}

TEST_CASE("what is near at the start is looked at wherever it slides", "[contact][contact_force][reach]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {8, 1, 1}, .size = {8, 1, 1}});
  b.add_hexes({.id = 2, .origin = {0.25, 0.25, 0.99}, .size = {0.5, 0.5, 0.5}, .share_nodes = false});
  const std::string sides =
      GENERATE(as<std::string>{}, "surfaces = low high\n", "side a = low\nside b = high\n");
  ContactBodies bodies(b,
                       "contact surface low contains block_1\ncontact surface high contains block_2\n"
                       "begin interaction\n" +
                           sides + "search distance = 0.1\n" + stiff + formulation() + "end\n");
  bodies.ask();
  move(bodies, {5, 0, 0});
  CHECK(lift(bodies) == Approx(25.0).epsilon(0.05));
}

TEST_CASE("an overlap of the start is near, however short SEARCH DISTANCE is",
          "[contact][contact_force][reach]") {
  ContactBodies bodies(stacked_cubes(-0.05, 4),
                       general_contact("search distance = 0\n" + stiff + formulation()));
  bodies.ask();
  CHECK(lift(bodies) == Approx(500.0).epsilon(0.03));
}

TEST_CASE("SEARCH DISTANCE holds for planes, rods and sheets", "[contact][contact_force][reach]") {
  const double gap = GENERATE(0.09, 0.11);
  const std::string line = "search distance = 0.1\n" + stiff;
  MeshBuilder rods;
  add_rod(rods, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(rods, {.id = 2, .cells = 3, .from = {0.1, -1, 0.2 + gap}, .to = {0.1, 1, 0.2 + gap}});
  ContactBodies crossing(rods, general_contact(line));
  crossing.ask();
  move(crossing, {0, 0, -gap - 0.01});
  CHECK((lift(crossing) > 0.0) == (gap < 0.1));

  MeshBuilder sheets;
  add_plate(sheets, {.id = 1, .cells = {2, 2}}, 0.1);
  add_plate(sheets, {.id = 2, .cells = {3, 3}, .origin = {0, 0, 0.1 + gap}, .share_nodes = false}, 0.1);
  ContactBodies plates(sheets, general_contact(line));
  plates.ask();
  move(plates, {0, 0, -gap - 0.01});
  CHECK((lift(plates) > 0.0) == (gap < 0.1));

  Region region = parse_region(
      "begin analytic object floor\ntype = plane\nnormal direction = 0 0 1\norigin = 0 0 0\nend\n");
  region.contact = parse_contact(
      "contact surface body contains block_1\ncontact surface wall contains floor\n"
      "begin interaction\nsurfaces = wall body\n" +
      line + "end\n");
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 2}, .origin = {0, 0, gap}, .size = {1, 1, 1}});
  ContactBodies body(b, region);
  body.ask();
  body.set_velocity(0, {0, 0, -(gap + 0.01) / 100});
  for (int i = 0; i < 100; ++i) body.step(1.0);
  CHECK((body.force_on(0).z() > 0.0) == (gap < 0.1));
}

TEST_CASE("what slides infinitesimally keeps the plane of its start face",
          "[contact][contact_force][small_sliding]") {
  ContactBodies bodies(cube_on_row(), general_contact(small + stiff + formulation()));
  bodies.ask();
  CHECK(lift(bodies) == Approx(press_on_row).epsilon(0.01));
  double least = 1e9, most = 0.0;
  bodies.set_velocity(1, {0.01, 0, 0});
  for (int i = 0; i < 70; ++i) {
    bodies.step(1.0);
    least = std::min(least, lift(bodies));
    most = std::max(most, lift(bodies));
    REQUIRE(bodies.net_force().norm() < 1e-9);
    REQUIRE(bodies.net_moment().norm() < 1e-9);
  }
  CHECK(least > 0.95 * press_on_row);
  CHECK(most < 1.05 * press_on_row);
  CHECK(bodies.force_on(1).head<2>().norm() < 1e-9);
}

TEST_CASE("a slide much shorter than a face is the same, small or not",
          "[contact][contact_force][small_sliding]") {
  const std::string of = formulation();
  ContactBodies slides(cube_on_row(), general_contact(stiff + of)),
      keeps(cube_on_row(), general_contact(small + stiff + of));
  for (ContactBodies* bodies : {&slides, &keeps}) {
    bodies->ask();
    move(*bodies, {1e-5, 2e-5, -1e-3}, 10);
  }
  CHECK(lift(keeps) == Approx(lift(slides)).epsilon(1e-3));
}

TEST_CASE("without a slide both behaviors are the same bits", "[contact][contact_force][small_sliding]") {
  const std::string of = formulation();
  ContactBodies slides(cube_on_row(), general_contact(stiff + of)),
      keeps(cube_on_row(), general_contact(small + stiff + of));
  slides.ask();
  keeps.ask();
  CHECK(slides.forces == keeps.forces);
}

TEST_CASE("what leaves the border of the still side keeps its plane too, and lifts off it",
          "[contact][contact_force][small_sliding]") {
  ContactBodies bodies(cube_on_row(), general_contact(small + stiff + formulation()));
  bodies.ask();
  move(bodies, {0, 0.5, 0});
  CHECK(lift(bodies) == Approx(press_on_row).epsilon(0.05));
  move(bodies, {0, 0, 0.011});
  CHECK(lift(bodies) == 0.0);
  move(bodies, {0, 0, -0.021});
  CHECK(lift(bodies) > press_on_row);
}

TEST_CASE("a far partner of the start is found by SEARCH DISTANCE",
          "[contact][contact_force][small_sliding]") {
  const bool has_distance = GENERATE(true, false);
  const std::string line = has_distance ? "search distance = 0.6\n" : "";
  ContactBodies bodies(stacked_cubes(0.5), general_contact(small + line + stiff + formulation()));
  bodies.ask();
  move(bodies, {0, 0, -0.51});
  CHECK(lift(bodies) == Approx(has_distance ? 100.0 : 0.0).epsilon(0.01));
}

}  // namespace contact_force_reach_test
