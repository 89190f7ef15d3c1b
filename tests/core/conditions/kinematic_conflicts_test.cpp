// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/kinematic_conflicts.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

PrescribedMotion motion_of(MotionType type, const Direction& direction,
                           std::vector<NodeIndex> nodes = {{1}}) {
  PrescribedMotion motion;
  motion.type = type;
  motion.direction = direction;
  motion.nodes = std::move(nodes);
  motion.label.what = "the motion";
  return motion;
}

std::string name_of_place(NodeIndex node) { return "place " + std::to_string(node.value); }

/// How many conflicts two motions of one node have.
std::size_t n_conflicts(const PrescribedMotion& first, const PrescribedMotion& second) {
  Diagnostics diagnostics;
  const std::vector<PrescribedMotion> motions{first, second};
  check_conflicts(motions, name_of_place, diagnostics);
  return diagnostics.error_count();
}

DeckLocation line_of_source(int line) {
  static const auto source = std::make_shared<const SourceFile>(SourceFile{"a.i", "1\n2\n3\n"});
  return {source, line, 1, nullptr};
}

constexpr MotionType driven = MotionType::velocity, held = MotionType::fixed;

}  // namespace

TEST_CASE("the nodes of two motions are those of both, ascending", "[core][conditions]") {
  const Direction x = Components{{true, false, false}};
  const auto a = motion_of(held, x, {{1}, {3}, {4}, {9}}), b = motion_of(held, x, {{0}, {3}, {9}, {12}});
  CHECK(shared_nodes(a, b) == std::vector<NodeIndex>{{3}, {9}});
  CHECK(shared_nodes(a, motion_of(held, x, {})).empty());
  CHECK(shared_nodes(a, motion_of(held, x, {{2}, {5}})).empty());
}

TEST_CASE("directions are oblique unless they are parallel or at right angles", "[core][conditions]") {
  const auto oblique = [](const Direction& a, const Direction& b) {
    return are_oblique(motion_of(held, a), motion_of(held, b)) &&
           are_oblique(motion_of(held, b), motion_of(held, a));
  };
  const Components xy{{true, true, false}}, z{{false, false, true}};
  CHECK_FALSE(oblique(xy, z));
  CHECK_FALSE(oblique(xy, xy));
  CHECK_FALSE(oblique(xy, Eigen::Vector3d(0, -1, 0)));
  CHECK(oblique(xy, Eigen::Vector3d(0.6, 0.8, 0)));
  CHECK_FALSE(oblique(z, Eigen::Vector3d(0.6, 0.8, 0)));
  // Decks write unit vectors to some seven digits: an angle of 1e-7 is none, one of 1e-5 is.
  CHECK_FALSE(oblique(z, Eigen::Vector3d(1e-7, 0, 1)));
  CHECK_FALSE(oblique(z, Eigen::Vector3d(1, 0, 1e-7)));
  CHECK(oblique(z, Eigen::Vector3d(1e-5, 0, 1)));
  CHECK(oblique(z, Eigen::Vector3d(1, 0, 1e-5)));
}

TEST_CASE("motions share a node where all that they drive is at right angles", "[core][conditions]") {
  const Components x{{true, false, false}}, yz{{false, true, true}}, xy{{true, true, false}};
  const Eigen::Vector3d slanted(0.6, 0.8, 0), across(-0.8, 0.6, 0);
  CHECK(n_conflicts(motion_of(driven, x), motion_of(driven, yz)) == 0);
  CHECK(n_conflicts(motion_of(driven, xy), motion_of(driven, yz)) == 1);
  CHECK(n_conflicts(motion_of(driven, slanted), motion_of(driven, across)) == 0);
  CHECK(n_conflicts(motion_of(driven, slanted), motion_of(driven, x)) == 1);
  CHECK(n_conflicts(motion_of(driven, slanted), motion_of(held, x)) == 1);
  CHECK(n_conflicts(motion_of(held, slanted), motion_of(held, x)) == 0);              // both hold
  CHECK(n_conflicts(motion_of(driven, x, {{1}}), motion_of(driven, x, {{2}})) == 0);  // other nodes
}

TEST_CASE("an axis drives the plane at right angles to it", "[core][conditions]") {
  const Axis about_z{{5, 5, 0}, Eigen::Vector3d::UnitZ()}, about_x{{0, 0, 0}, Eigen::Vector3d::UnitX()};
  const Components z{{false, false, true}}, x{{true, false, false}};
  for (const bool is_first : {true, false}) {
    const auto n = [&](const Direction& axis, const Direction& other) {
      const auto a = motion_of(driven, axis), b = motion_of(held, other);
      return is_first ? n_conflicts(a, b) : n_conflicts(b, a);
    };
    CHECK(n(about_z, z) == 0);
    CHECK(n(about_z, Eigen::Vector3d(0, 0, -1)) == 0);
    CHECK(n(about_z, x) == 1);
    CHECK(n(about_z, Eigen::Vector3d(0.6, 0, 0.8)) == 1);
  }
  CHECK(n_conflicts(motion_of(driven, about_z), motion_of(driven, about_z)) == 1);
  CHECK(n_conflicts(motion_of(driven, about_z), motion_of(driven, about_x)) == 1);
}

TEST_CASE("motions at different times do not disturb each other, slanted holds must act alike",
          "[core][conditions]") {
  const Components x{{true, false, false}};
  const ActiveTimes early({{0.0, 1.0}}), late({{1.0, 2.0}}), both({{0.0, 2.0}});
  auto a = motion_of(driven, x), b = motion_of(driven, x);
  a.times = early;
  b.times = late;
  CHECK(n_conflicts(a, b) == 0);
  b.times = both;
  CHECK(n_conflicts(a, b) == 1);
  auto hold = motion_of(held, x), straight = hold, slanted = motion_of(held, Eigen::Vector3d(0.6, 0.8, 0));
  hold.times = early;
  straight.times = slanted.times = both;
  CHECK(n_conflicts(hold, straight) == 0);
  CHECK(n_conflicts(hold, slanted) == 1);
  slanted.times = early;
  CHECK(n_conflicts(hold, slanted) == 0);
}

TEST_CASE("every pair of conflicting motions is reported at its later one", "[core][conditions]") {
  const Components x{{true, false, false}};
  std::vector<PrescribedMotion> motions{motion_of(driven, x, {{0}, {1}, {2}}),
                                        motion_of(driven, x, {{1}, {2}, {7}}), motion_of(driven, x, {{7}})};
  for (int i = 0; i < 3; ++i) motions[static_cast<std::size_t>(i)].label.location = line_of_source(i + 1);
  Diagnostics diagnostics;
  check_conflicts(motions, name_of_place, diagnostics);
  const std::string end =
      " in one direction at one time; take the nodes out of one of them, or give them other periods\n";
  CHECK(messages(diagnostics) ==
        "a.i:2:1: error: the motion and the motion at a.i:1:1 both drive place 1 and 1 more" + end +
            "a.i:3:1: error: the motion and the motion at a.i:2:1 both drive place 7" + end);
  Diagnostics of_none;
  check_conflicts({}, name_of_place, of_none);
  CHECK(of_none.empty());
}
