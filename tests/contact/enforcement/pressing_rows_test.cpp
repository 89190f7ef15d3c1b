// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/pressing_rows.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "support/catch.hpp"
#include "support/two_cubes.hpp"

namespace pressing_rows_test {

using namespace contactsim;

namespace {

constexpr double dt = 0.1;

/// Rows of groups with carriers that chance gives them, five or eight, among the nodes of two cubes.
struct RandomRows {
  test::TwoCubes cubes;
  ModelFreeDirections free;
  NodeMobility mobility;
  State state;
  ConstraintSystem system;
  PressingRows pressing{mobility};

  explicit RandomRows(std::uint32_t n_groups) {
    free.update(cubes.model, 0.0);
    state = cubes.state(dt);
    mobility.begin(cubes.model, free, cubes.parts.kinematics, state);
    for (std::uint32_t node = 0; node < 16; ++node) mobility.plain_carrier({node});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.05, 1.0);
    std::vector<std::uint32_t> carriers(16);
    std::iota(carriers.begin(), carriers.end(), 0u);
    for (std::uint32_t g = 0; g < n_groups; ++g) {
      std::ranges::shuffle(carriers, random);
      ConstraintGroup& group = system.groups.emplace_back();
      group.presses = true;
      group.normal = node_vector(Eigen::Vector3d(share(random), -share(random), share(random)).normalized());
      group.first_row = static_cast<std::uint32_t>(system.rows.size());
      group.n_rows = 1 + g % 3;
      group.terms.n_terms = g % 2 == 0 ? 8 : 5;
      std::copy_n(carriers.begin(), group.terms.n_terms, group.terms.carriers.begin());
      for (std::uint32_t i = 0; i < group.n_rows; ++i) add_row(group, share, random);
    }
    mobility.begin_passes();
    pressing.list(system);
  }

  void add_row(const ConstraintGroup& group, std::uniform_real_distribution<double>& share,
               std::mt19937& random) {
    ConstraintRow& row = system.rows.emplace_back();
    row.point = static_cast<std::uint32_t>(system.points.size());
    row.area = share(random);
    row.start = 0.5 - share(random);
    row.force = 0.1 * share(random) * group.normal;
    row.pulls = system.rows.size() % 7 == 0;
    row.softness = share(random);
    system.points.emplace_back().area = row.area;
    auto& weights = system.weights.emplace_back();
    weights.fill(0.0);
    for (std::size_t k = 0; k < group.terms.n_terms; ++k) weights[k] = k < 4 ? share(random) : -share(random);
  }

  /// Passes with momentum; the changes of velocity by the last one.
  std::vector<NodeVector> changes(int n_passes, ConstraintPass& sums) {
    pressing.begin_passes(system);
    pressing.push_forces(system);
    mobility.end_pass();
    for (int i = 0; i < n_passes; ++i) {
      sums = pressing.pass(system, dt, 0.3);
      mobility.end_pass();
    }
    return {mobility.changes().begin(), mobility.changes().end()};
  }

  /// Adds what rows push with to the changes of velocity.
  void push_slowly(std::vector<NodeVector>& changes) const {
    std::fill(changes.begin(), changes.end(), NodeVector::Zero());
    system.visit_rows([&](const ConstraintGroup& group, std::uint32_t i) {
      for (std::size_t k = 0; k < group.terms.n_terms; ++k) {
        const std::uint32_t carrier = group.terms.carriers[k];
        changes[carrier] += mobility.translation_bound(carrier) * system.weights[i][k] * system.rows[i].ahead;
      }
    });
  }

  /// The same by vectors, row by row.
  std::vector<NodeVector> slow_changes(int n_passes, ConstraintPass& sums) {
    std::vector<NodeVector> changes(16);
    for (ConstraintRow& row : system.rows) row.ahead = row.force;
    push_slowly(changes);
    for (int pass = 0; pass < n_passes; ++pass) {
      sums = {};
      system.visit_rows([&](const ConstraintGroup& group, std::uint32_t i) {
        ConstraintRow& row = system.rows[i];
        NodeVector velocity = NodeVector::Zero();
        for (std::size_t k = 0; k < group.terms.n_terms; ++k)
          velocity += system.weights[i][k] * changes[group.terms.carriers[k]];
        const double now = group.normal.dot(row.ahead);
        const double opened =
            row.start + dt * group.normal.dot(velocity) + constraint_compliance * row.softness * now;
        const double closing = now - (1.0 - constraint_compliance) / row.softness * opened;
        sums.take(row, NodeVector((row.pulls ? closing : std::max(0.0, closing)) * group.normal), 0.3);
      });
      push_slowly(changes);
    }
    return changes;
  }
};

double difference(const std::vector<NodeVector>& a, const std::vector<NodeVector>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

}  // namespace

TEST_CASE("rows that press do what rows of vectors do", "[contact][pressing_rows]") {
  RandomRows rows(20), slow(20);
  ConstraintPass sums, slow_sums;
  const auto changes = rows.changes(3, sums), slow_changes = slow.slow_changes(3, slow_sums);
  REQUIRE(slow_changes[0].norm() > 0.1);
  // Forces that grow to thousands in three passes that converge not at all, by round-off of 1e-16.
  CHECK(difference(changes, slow_changes) < 1e-12 * slow_sums.all);
  CHECK(sums.all == Approx(slow_sums.all));
  CHECK(sums.changed == Approx(slow_sums.changed));
  CHECK(sums.uphill == Approx(slow_sums.uphill));
}

TEST_CASE("rows that press have the same bits for any number of threads", "[contact][pressing_rows]") {
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  RandomRows one(1500);
  ConstraintPass sums;
  const auto changes = one.changes(2, sums);
  LeaningAreas areas(16, {0.0, 0.0});
  one.pressing.add_areas(one.system, areas);
  for (const int n_threads : {2, 3}) {
    omp_set_num_threads(n_threads);
    RandomRows other(1500);
    REQUIRE(other.system.n_threads() == n_threads);
    ConstraintPass other_sums;
    CHECK(other.changes(2, other_sums) == changes);
    CHECK(other_sums.all == sums.all);
    CHECK(other_sums.uphill == sums.uphill);
    LeaningAreas other_areas(16, {0.0, 0.0});
    other.pressing.add_areas(other.system, other_areas);
    CHECK(other_areas == areas);
  }
  omp_set_num_threads(before);
}

TEST_CASE("groups that do not press stay as they are among those that do", "[contact][pressing_rows]") {
  RandomRows all(50), some(50);
  for (std::size_t g = 0; g < 50; g += 3) {
    some.system.groups[g].presses = false;
    // Those of the others push nothing, so that what is left is alike.
    ConstraintGroup& group = all.system.groups[g];
    for (std::uint32_t i = group.first_row; i < group.first_row + group.n_rows; ++i) {
      all.system.weights[i].fill(0.0);
      all.system.rows[i].force.setZero();
      all.system.rows[i].start = 1.0;
    }
  }
  some.pressing.list(some.system);
  CHECK(some.pressing.n_groups() == 33);
  ConstraintPass sums, sums_of_some;
  const auto changes = all.changes(2, sums), of_some = some.changes(2, sums_of_some);
  REQUIRE(changes[0].norm() > 0.1);
  CHECK(difference(changes, of_some) < 1e-12 * sums.all);
}

TEST_CASE("the softness of rows that press is that of their carriers by the areas that lean on them",
          "[contact][pressing_rows]") {
  RandomRows rows(6);
  LeaningAreas areas(16, {0.0, 0.0});
  rows.pressing.add_areas(rows.system, areas);
  CHECK_FALSE(rows.pressing.set_softness(areas, dt, rows.system));
  std::vector<double> slow(16, 0.0);
  const auto visit = [&](const auto& take) {
    rows.system.visit_rows([&](const ConstraintGroup& group, std::uint32_t i) {
      for (std::size_t k = 0; k < group.terms.n_terms; ++k)
        take(i, group.terms.carriers[k], std::abs(rows.system.weights[i][k]));
    });
  };
  visit([&](std::uint32_t i, std::uint32_t carrier, double weight) {
    slow[carrier] += rows.system.rows[i].area * weight;
  });
  for (std::size_t c = 0; c < 16; ++c) CHECK(areas[c][0] == Approx(slow[c]));
  std::vector<double> softness(rows.system.rows.size(), 0.0);
  visit([&](std::uint32_t i, std::uint32_t carrier, double weight) {
    softness[i] +=
        dt / rows.system.rows[i].area * rows.mobility.translation_bound(carrier) * weight * slow[carrier];
  });
  for (std::size_t i = 0; i < softness.size(); ++i)
    CHECK(rows.system.rows[i].softness == Approx(softness[i]));
  rows.system.weights[2].fill(0.0);
  CHECK(rows.pressing.set_softness(areas, dt, rows.system));
}

}  // namespace pressing_rows_test
