// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/pair_histories.hpp"

#include <cmath>

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// Steps of a pair in which contact points press.
struct PressedPair {
  test::TwoCubes cubes;
  ContactAssembler sums{16, 1, false};
  PairHistories histories{1};

  explicit PressedPair(const std::string& more = "") : cubes(more) {}
  /// A step whose points push along z, with what they lose.
  double step(const std::vector<ContactPoint>& points, double dt) {
    sums.begin_step();
    for (const ContactPoint& point : points) {
      sums.add(point);
      sums.note_penetration(point, 2.0);
    }
    return histories.add(sums, cubes.parts.rules.gap_offsets(), dt);
  }
  const PairHistory& history() const { return histories.all()[{0}]; }
  double available() { return histories.update_available_energy(cubes.parts.rules, sums)[{0}]; }
};

/// It stores force x depth / 2.
ContactPoint sprung(double force, double depth, double dissipated = 0.0) {
  ContactPoint point = test::TwoCubes::corner_over_face();
  point.force = force;
  point.gap = -depth;
  point.dissipated = dissipated;
  return point;
}

}  // namespace

TEST_CASE("a pair that never touched keeps all zero", "[contact][pair_histories]") {
  PressedPair pair;
  CHECK(pair.step({sprung(0.0, -0.1)}, 0.5) == 0.0);
  CHECK_FALSE(pair.history().has_touched());
  CHECK(pair.history().deepest == 0.0);
  CHECK(std::isnan(pair.history().lost_time));
}

TEST_CASE("a pair adds up time, impulse and losses, and keeps the peaks", "[contact][pair_histories]") {
  PressedPair pair;
  pair.step({sprung(10.0, 0.2, 0.3), sprung(2.0, 0.1)}, 0.5);
  pair.step({sprung(4.0, 0.4, 0.1)}, 0.25);
  pair.step({}, 0.5);
  const PairHistory& history = pair.history();
  CHECK(history.contact_time == 0.75);
  CHECK(history.peak_force == 12.0);
  // Of the second surface: down.
  CHECK(history.impulse.isApprox(Vector3d(0, 0, -(12.0 * 0.5 + 4.0 * 0.25))));
  CHECK(history.friction_work == Approx(0.4));
  CHECK(history.deepest == 0.4);
  CHECK(history.deepest_share == 0.2);
  CHECK(history.work == Approx(0.4));  // springs hold nothing now
  pair.step({sprung(10.0, 0.2)}, 0.5);
  CHECK(history.work == Approx(1.4));
}

TEST_CASE("what the mesh's own overlaps store was there at the start", "[contact][pair_histories]") {
  PressedPair pair;
  pair.sums.begin_step();
  pair.sums.add(sprung(10.0, 0.2));
  pair.histories.begin(pair.sums);
  CHECK(pair.history().stored_at_start == 1.0);
  pair.step({sprung(10.0, 0.2)}, 0.5);
  CHECK(pair.history().made() == 0.0);
  CHECK(pair.available() == 1.0);
  // Springs without all that: destroyed.
  pair.step({}, 0.5);
  CHECK(pair.history().made() == -1.0);
}

TEST_CASE("the first of the contacts that ended deep is named, of pairs that are on",
          "[contact][pair_histories]") {
  PressedPair pair;
  const std::vector<LostContact> lost{{{0}, {9}, 0.3}, {{0}, {8}, 0.7}};
  pair.cubes.parts.rules.activate(0.0, false);
  pair.histories.add_lost(lost, pair.cubes.parts.rules, pair.cubes.parts.contact_mesh, 1.0);
  CHECK(pair.history().n_lost == 0);
  pair.cubes.parts.rules.activate(0.0, true);
  for (const double time : {2.0, 3.0})
    pair.histories.add_lost(lost, pair.cubes.parts.rules, pair.cubes.parts.contact_mesh, time);
  CHECK(pair.history().n_lost == 4);
  CHECK(pair.history().lost_node == NodeIndex{9});
  CHECK(pair.history().lost_time == 2.0);
  CHECK(pair.history().lost_depth == 0.3);
}

TEST_CASE("how far something is beyond its face of the start is the largest so far, of either side",
          "[contact][pair_histories]") {
  PressedPair pair;
  const auto note = [&](const Eigen::Vector4d& first, const Eigen::Vector4d& second, double force) {
    ContactPoint point = sprung(force, 0.1);
    point.first.nodes = {8, 9, 11, 10};
    point.first.weights = first;
    point.second.weights = second;
    pair.histories.note_slide(point, pair.cubes.parts.contact_mesh);
  };
  const Eigen::Vector4d inside = Eigen::Vector4d::Constant(0.25);
  note(inside, {1.5, -0.5, 0, 0}, 0.0);  // it does not touch
  note(inside, inside, 1.0);
  CHECK(pair.history().slid_share == 0.0);
  note(inside, {1.25, -0.25, 0, 0}, 1.0);
  CHECK(pair.history().slid_share == 0.25);
  CHECK(pair.history().slid_node == NodeIndex{8});
  note({0, -0.5, 0.5, 1.0}, inside, 1.0);
  CHECK(pair.history().slid_share == 0.5);
  CHECK(pair.history().slid_node == NodeIndex{4});
  note(inside, {1.25, -0.25, 0, 0}, 1.0);
  CHECK(pair.history().slid_share == 0.5);
}

TEST_CASE("what deaths have released is counted and its first node named", "[contact][pair_histories]") {
  PressedPair pair;
  const ContactMesh& contact_mesh = pair.cubes.parts.contact_mesh;
  pair.histories.add_released({}, {}, contact_mesh);
  CHECK(pair.history().n_released == 0);
  const std::vector<ReleasedPartner<SurfaceNodeIndex>> rows{{{9}, {0}}, {{3}, {0}}};
  pair.histories.add_released({}, rows, contact_mesh);
  CHECK(pair.history().n_released == 2);
  CHECK(pair.history().released_node == contact_mesh.mesh_nodes[contact_mesh.surface_nodes[{9}].node]);
  const std::vector<ReleasedPartner<FaceIndex>> faces{{{5}, {0}}};
  pair.histories.add_released(faces, {}, contact_mesh);
  CHECK(pair.history().n_released == 3);
  CHECK(pair.history().released_node == contact_mesh.mesh_nodes[contact_mesh.surface_nodes[{9}].node]);
  PressedPair other;
  other.histories.add_released(faces, rows, contact_mesh);
  CHECK(other.history().released_node == contact_mesh.mesh_nodes[contact_mesh.faces[{5}].corners[0]]);
}

TEST_CASE("what springs stored that are gone is lost", "[contact][pair_histories]") {
  PressedPair pair;
  const ContactPoint kept = sprung(10.0, 0.2), gone = sprung(4.0, 0.5);
  pair.step({kept, gone}, 0.5);
  CHECK(pair.history().work == 2.0);
  ContactPoint apart = sprung(0.0, 0.3);
  apart.beyond_spring = 5.0;
  ConstraintForces held;
  held.constraint.pair = {0};
  held.forces.forces.setZero();
  held.forces.stored = 0.25;
  pair.histories.forget_stored(std::vector{kept, apart}, std::vector{held});
  pair.step({kept}, 0.5);
  // The springs of one point are gone with their energy, those of the constraint give theirs back.
  CHECK(pair.history().work == 1.75);
}

TEST_CASE("the energy that springs may give is what the pair took and has not lost",
          "[contact][pair_histories]") {
  PressedPair pair;
  pair.step({sprung(10.0, 0.2, 0.25)}, 0.5);  // takes nothing, for nothing moves
  CHECK(pair.available() == -0.25);
  CHECK(pair.histories.min_energy()[{0}] == -0.25);
  pair.step({sprung(10.0, 0.2, -1.0)}, 0.5);
  CHECK(pair.available() == 0.75);
  CHECK(pair.histories.min_energy()[{0}] == -0.25);
}

TEST_CASE("pairs that pull, tie, are balanced or ramped have no limit", "[contact][pair_histories]") {
  CHECK(std::isnan(PressedPair("enforcement = momentum_balance\n").available()));
  CHECK(std::isnan(PressedPair("friction model = tied\n").available()));
  CHECK(PressedPair("friction model = frictionless\n").available() == 0.0);
  PressedPair ramped("overlap ramp time = 2\n");
  ramped.cubes.parts.rules.gap_offsets().set_start({}, 0.0);
  CHECK(ramped.available() == 0.0);
  ramped.cubes.parts.rules.activate(1.0, true);
  CHECK(std::isnan(ramped.available()));
}

TEST_CASE("ramps of overlaps supply the mean force of both ends of a step times what came in",
          "[contact][pair_histories]") {
  PressedPair pair("overlap ramp time = 2\n");
  GapOffsets& offsets = pair.cubes.parts.rules.gap_offsets();
  offsets.set_start({}, 0.0);
  const ContactPoint point = sprung(10.0, 0.2);
  const auto ramp = [&](double time, double force) {
    offsets.activate(time);
    pair.sums.begin_step();
    ContactPoint pressed = point;
    pressed.force = force;
    pair.sums.note_ramp(pressed, 0.5);
    return pair.histories.add(pair.sums, offsets, 0.5);
  };
  CHECK(ramp(0.5, 8.0) == Approx(0.25 * 0.5 * (0.0 + 8.0) * 0.5));
  CHECK(ramp(1.5, 4.0) == Approx(0.5 * 0.5 * (8.0 + 4.0) * 0.5));
  CHECK(ramp(3.0, 4.0) == Approx(0.25 * 4.0 * 0.5));
  CHECK(ramp(4.0, 4.0) == 0.0);
  CHECK(pair.history().ramped == Approx(0.5 + 1.5 + 0.5));
}

TEST_CASE("histories of pairs go on from a stored state", "[contact][pair_histories]") {
  PressedPair pair, other;
  pair.step({sprung(10.0, 0.2, 0.25)}, 0.5);
  pair.available();
  pair.histories.add_lost(std::vector{LostContact{{0}, {9}, 0.3}}, pair.cubes.parts.rules,
                          pair.cubes.parts.contact_mesh, 1.0);
  StateArchive saves;
  pair.histories.archive(saves);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  other.histories.archive(restores);
  for (PressedPair* one : {&pair, &other}) {
    one->step({sprung(12.0, 0.3, 0.5)}, 0.25);
    one->available();
  }
  CHECK(other.history().work == pair.history().work);
  CHECK(other.history().impulse == pair.history().impulse);
  CHECK(other.history().contact_time == 0.75);
  CHECK(other.history().lost_node == NodeIndex{9});
  CHECK(other.history().lost_time == 1.0);
  CHECK(other.histories.min_energy()[{0}] == pair.histories.min_energy()[{0}]);
}
