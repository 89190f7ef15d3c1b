// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/narrow_phase.hpp"

#include <omp.h>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using test::ContactParts;

namespace {

constexpr std::size_t n_all = 10000;  // rows, enough for several threads

/// Finds a point in every third row.
struct EveryThird {
  std::vector<std::uint32_t> updated = {};  // rows, in the order in which they were taken over

  std::size_t n_rows() const { return n_all; }
  void detect(const ContactStepContext&, CandidateRows rows, std::vector<ContactPoint>& points) const {
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
  NarrowPhase narrow_phase;
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
  NarrowPhase narrow_phase;
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
