// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/constraint_system.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Groups of 1, 2, 3, 1, 2, 3... rows, each with a point of its own.
ConstraintSystem system_of_groups(std::uint32_t n_groups) {
  ConstraintSystem system;
  for (std::uint32_t g = 0; g < n_groups; ++g) {
    ConstraintGroup& group = system.groups.emplace_back();
    group.first_row = static_cast<std::uint32_t>(system.rows.size());
    group.n_rows = 1 + g % 3;
    for (std::uint32_t i = 0; i < group.n_rows; ++i) {
      system.rows.emplace_back().point = static_cast<std::uint32_t>(system.points.size());
      system.rows.back().softness = 1.0;
      system.ids.push_back({0, system.rows.back().point, 0, 0});
      system.weights.emplace_back()[0] = system.points.emplace_back().area = 1.0 + system.rows.back().point;
    }
  }
  return system;
}

/// A sum that depends on the order of its terms.
struct InverseSum {
  double sum = 0.0;
  InverseSum& operator+=(const InverseSum& other) {
    sum += other.sum;
    return *this;
  }
};

ContactPoint corner_on_face() {
  ContactPoint point;
  point.first.nodes.fill({8});
  point.second.nodes = {{{4}, {5}, {7}, {6}}};
  point.normal = Eigen::Vector3d::UnitZ();
  return point;
}

}  // namespace

TEST_CASE("sums over rows have the bits of chunks of 64 groups for any number of threads",
          "[contact][constraint_system]") {
  const ConstraintSystem system = system_of_groups(500);
  double slow = 0.0;
  for (std::size_t begin = 0; begin < 500; begin += 64) {
    double of_chunk = 0.0;
    for (std::size_t g = begin; g < std::min<std::size_t>(begin + 64, 500); ++g) {
      for (std::uint32_t i = 0; i < system.groups[g].n_rows; ++i)
        of_chunk += 1.0 / (1.0 + system.groups[g].first_row + i);
    }
    slow += of_chunk;
  }
  for (const int n_threads : {1, 2, 5}) {
    const auto fast = system.sum_rows<InverseSum>(
        n_threads, [&](const ConstraintGroup& group, std::uint32_t row, InverseSum& sums) {
          CHECK(row - group.first_row < group.n_rows);
          sums.sum += 1.0 / system.point_of(system.rows[row]).area;
        });
    CHECK(fast.sum == slow);
  }
}

TEST_CASE("rows without softness are removed, with the groups that have no others",
          "[contact][constraint_system]") {
  // Rows 0 | 1 2 | 3 4 5 | 6.
  ConstraintSystem system = system_of_groups(4);
  for (const std::size_t row : {0, 2, 3}) system.rows[row].softness = 0.0;
  system.remove_rigid_rows();
  REQUIRE(system.groups.size() == 3);
  REQUIRE(system.rows.size() == 4);
  REQUIRE(system.weights.size() == 4);
  CHECK(system.points.size() == 7);
  const std::array<std::uint32_t, 3> first_rows{0, 1, 3}, n_rows{1, 2, 1};
  for (std::size_t g = 0; g < 3; ++g) {
    CHECK(system.groups[g].first_row == first_rows[g]);
    CHECK(system.groups[g].n_rows == n_rows[g]);
  }
  const std::array<std::uint32_t, 4> points{1, 4, 5, 6};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(system.rows[i].point == points[i]);
    CHECK(system.weights[i][0] == 1.0 + points[i]);
    CHECK(system.ids[i].first == points[i]);
  }
}

TEST_CASE("a point belongs to the last group by its nodes and its normal", "[contact][constraint_system]") {
  ConstraintSystem system;
  const ContactPoint point = corner_on_face();
  CHECK_FALSE(system.is_of_last_group(point));
  system.points.push_back(point);
  system.rows.emplace_back();
  system.groups.emplace_back();
  CHECK(system.is_of_last_group(point));
  ContactPoint other = point;
  other.normal = Eigen::Vector3d::UnitX();
  CHECK_FALSE(system.is_of_last_group(other));
  other = point;
  other.first.nodes.fill({9});
  CHECK_FALSE(system.is_of_last_group(other));
  other = point;
  std::swap(other.second.nodes[0], other.second.nodes[1]);
  CHECK_FALSE(system.is_of_last_group(other));
  // Carriers with arms are those of one point alone.
  system.groups.back().terms.first_arm = 0;
  CHECK_FALSE(system.is_of_last_group(point));
}
