// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/narrow_phase.hpp"

#include <omp.h>

#include <atomic>
#include <mutex>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using test::ContactParts;

namespace {

constexpr std::size_t n_all = 10000;  // rows, enough for several threads

/// Finds a point in every third row.
struct EveryThird {
  std::vector<std::uint32_t> updated = {};  // rows, in the order in which they were taken over
  mutable std::atomic<std::size_t> n_rows_detected = 0;

  std::size_t n_rows() const { return n_all; }
  void detect(const ContactStepContext&, CandidateRows rows, std::vector<ContactPoint>& points) const {
    n_rows_detected += rows.end - rows.begin;
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
      if (row % 3 == 0) points.emplace_back().first_entity = static_cast<std::uint32_t>(row);
    }
  }
  void update(const ContactStepContext&, CandidateRows, std::span<const ContactPoint> points) {
    for (const ContactPoint& point : points) updated.push_back(point.first_entity);
  }
};

/// The same; its points know each other before they are taken.
struct CompletedThird : EveryThird {
  void complete(const ContactStepContext&, std::span<ContactPoint> points) const {
    for (ContactPoint& point : points) point.area = static_cast<double>(points.size());
  }
};

std::vector<std::uint32_t> every_third() {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < n_all; row += 3) rows.push_back(row);
  return rows;
}

const ContactParts& cube() {
  static const ContactParts parts(test::MeshBuilder().add_hexes({.id = 1}), test::general_contact());
  return parts;
}

}  // namespace

TEST_CASE("contact points are taken in the order of their rows by any number of threads",
          "[contact][narrow_phase]") {
  const int before = omp_get_max_threads();
  omp_set_num_threads(GENERATE(1, 2, 4));
  NarrowPhase narrow_phase(one_rank());
  EveryThird formulation;
  std::vector<std::uint32_t> taken;
  for (int step = 0; step < 2; ++step)
    narrow_phase.visit_points(formulation, cube().context(),
                              [&](const ContactPoint& point) { taken.push_back(point.first_entity); });
  omp_set_num_threads(before);
  std::vector<std::uint32_t> twice = every_third();
  const std::vector<std::uint32_t> once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  CHECK(taken == twice);
  CHECK(formulation.updated == twice);
}

TEST_CASE("a formulation completes all its points before they are taken", "[contact][narrow_phase]") {
  NarrowPhase narrow_phase(one_rank());
  CompletedThird formulation;
  std::size_t n_taken = 0;
  for (int step = 0; step < 2; ++step) {
    n_taken = 0;
    narrow_phase.visit_points(formulation, cube().context(), [&](const ContactPoint& point) {
      n_taken += point.area == static_cast<double>(every_third().size()) ? 1 : 0;
    });
  }
  CHECK(n_taken == every_third().size());
}

TEST_CASE("each rank detects a part of the rows, and takes and remembers the points of all",
          "[contact][narrow_phase]") {
  const int n_ranks = GENERATE(2, 3, 7);
  std::mutex checking;
  cube();
  test::ThreadRanks(n_ranks).run([&](Ranks& ranks) {
    NarrowPhase narrow_phase(ranks);
    EveryThird formulation;
    std::vector<std::uint32_t> taken;
    narrow_phase.visit_points(formulation, cube().context(),
                              [&](const ContactPoint& point) { taken.push_back(point.first_entity); });
    const std::lock_guard lock(checking);
    CHECK(taken == every_third());
    CHECK(formulation.updated == every_third());
    CHECK(formulation.n_rows_detected <= n_all / static_cast<std::size_t>(n_ranks) + rows_per_chunk);
  });
}

TEST_CASE("points that know each other are completed on every rank", "[contact][narrow_phase]") {
  std::mutex checking;
  cube();
  test::ThreadRanks(3).run([&](Ranks& ranks) {
    NarrowPhase narrow_phase(ranks);
    CompletedThird formulation;
    std::size_t n_taken = 0;
    narrow_phase.visit_points(formulation, cube().context(), [&](const ContactPoint& point) {
      n_taken += point.area == static_cast<double>(every_third().size()) ? 1 : 0;
    });
    const std::lock_guard lock(checking);
    CHECK(n_taken == every_third().size());
  });
}
