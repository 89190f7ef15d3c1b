// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_history.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

/// A contact point of two faces.
ContactPoint point(std::uint32_t first, std::uint32_t second, std::uint8_t part) {
  ContactPoint contact_point;
  contact_point.first_entity = first;
  contact_point.second_entity = second;
  contact_point.part = part;
  contact_point.first.nodes = {0, 1, 2, 3};
  contact_point.second.weights = Eigen::Vector4d::Constant(0.25);
  return contact_point;
}

ContactHistory::PointId id(std::uint32_t first, std::uint32_t second, std::uint8_t part) {
  return ContactHistory::id_of(point(first, second, part));
}

/// Two points of faces 0 and 5, one of faces 0 and 7, one of faces 1 and 5.
ContactHistory some_points() {
  ContactHistory memory;
  memory.begin();
  memory.remember(point(0, 5, 0), {10.0, Vector3d(1, 0, 0), Vector3d(0, 1, 0), 0.1, 3.0});
  memory.remember(point(0, 5, 1), {20.0, Vector3d(2, 0, 0), Vector3d(0, 2, 0), 0.2, 1.0});
  memory.remember(point(0, 7, 0), {100.0, Vector3d::Zero(), Vector3d::Zero(), 0.0, 4.0});
  memory.remember(point(1, 5, 0), {7.0, Vector3d::Zero(), Vector3d::Zero(), 0.0, 1.0});
  memory.end();
  return memory;
}

}  // namespace

TEST_CASE("a contact point is known by its own number", "[contact][enforcement]") {
  ContactHistory memory = some_points();
  ContactHistory::Entry found;
  REQUIRE(memory.recall(id(0, 5, 1), found));
  CHECK(found.pressure == 20.0);
  CHECK(found.traction == Vector3d(2, 0, 0));
  CHECK(found.held == Vector3d(0, 2, 0));
  CHECK(found.left == 0.2);
}

TEST_CASE("a new contact point takes over the mean over area of its pair, else of its first face",
          "[contact][enforcement]") {
  ContactHistory memory = some_points();
  ContactHistory::Entry found;
  REQUIRE(memory.recall(id(0, 5, 8), found));
  CHECK(found.pressure == Approx((3.0 * 10.0 + 1.0 * 20.0) / 4.0));
  CHECK(found.traction.x() == Approx(1.25));
  CHECK(found.held.y() == Approx(1.25));
  CHECK(found.left == Approx(0.125));
  // Asked for out of order, and of a pair that was not there: 3, 1 and 4 of area.
  REQUIRE(memory.recall(id(0, 6, 0), found));
  CHECK(found.pressure == Approx((3.0 * 10.0 + 1.0 * 20.0 + 4.0 * 100.0) / 8.0));
  CHECK_FALSE(memory.recall(id(2, 5, 0), found));
}

TEST_CASE("points of which nothing is known are as if they were not there", "[contact][enforcement]") {
  ContactHistory memory;
  const auto points = memory.begin_points(4);
  points[0] = {id(0, 5, 0), {}};
  points[1] = {id(0, 5, 1), {20.0, Vector3d::Zero(), Vector3d::Zero(), 0.2, 1.0}};
  points[2] = {id(0, 7, 0), {40.0, Vector3d::Zero(), Vector3d::Zero(), 0.0, 3.0}};
  points[3] = {id(1, 5, 0), {}};
  memory.end();
  ContactHistory::Entry found;
  REQUIRE(memory.recall(id(0, 5, 0), found));
  CHECK(found.pressure == 20.0);  // that of its pair
  REQUIRE(memory.recall(id(0, 6, 0), found));
  CHECK(found.pressure == Approx((20.0 + 3.0 * 40.0) / 4.0));
  CHECK_FALSE(memory.recall(id(1, 5, 0), found));
  CHECK(memory.force_between(point(0, 5, 0)) == 20.0);
  StateArchive saves;
  memory.archive(saves);
  const SavedState saved = saves.take();
  ContactHistory restored;
  StateArchive restores(saved);
  restored.archive(restores);
  REQUIRE(restored.recall(id(0, 7, 0), found));
  CHECK(found.pressure == 40.0);
  CHECK_FALSE(restored.recall(id(1, 5, 0), found));
}
