// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/broad_phase.hpp"

#include <omp.h>

#include <limits>

#include "support/catch.hpp"
#include "support/fcl_boxes.hpp"
#include "support/moving_boxes.hpp"

using namespace contactsim;
using test::FclBoxes;
using test::in_rows;
using test::MovingBoxes;
using test::sweep;

namespace {

constexpr auto any = [](std::uint32_t, std::uint32_t) { return true; };

void check_equal(const PairTable& lists, const PairTable& expected) {
  REQUIRE(lists.begin == expected.begin);
  REQUIRE(lists.partners == expected.partners);
}

PairTable pairs_among(const std::vector<Box>& boxes) {
  BroadPhase phase;
  PairTable lists;
  REQUIRE_FALSE(phase.update(boxes));
  phase.find_pairs(any, lists);
  return lists;
}

PairTable pairs_between(const std::vector<Box>& rows, const std::vector<Box>& partners) {
  BroadPhase row_phase, partner_phase;
  PairTable lists;
  REQUIRE_FALSE(row_phase.update(rows));
  REQUIRE_FALSE(partner_phase.update(partners));
  row_phase.find_pairs(partner_phase, any, lists);
  return lists;
}

}  // namespace

TEST_CASE("pairs of two moving sets equal an all-pairs sweep and FCL's own", "[contact][broad_phase][Q12]") {
  MovingBoxes rows(200, 1), partners(200, 2);
  BroadPhase row_phase, partner_phase;
  FclBoxes fcl_rows(rows.boxes()), fcl_partners(partners.boxes());
  PairTable lists;
  for (int step = 0; step < 50; ++step, rows.step(), partners.step()) {
    REQUIRE_FALSE(row_phase.update(rows.boxes()));
    REQUIRE_FALSE(partner_phase.update(partners.boxes()));
    row_phase.find_pairs(
        partner_phase, [&](auto i, auto j) { return do_overlap(rows.boxes()[i], partners.boxes()[j]); },
        lists);
    REQUIRE(lists.partners.size() > 10);
    check_equal(lists, sweep(rows.boxes(), partners.boxes()));
    fcl_rows.update(rows.boxes());
    fcl_partners.update(partners.boxes());
    std::vector<RowPartner> both, one_by_one;
    fcl_rows.collide(fcl_partners, both);
    fcl_rows.collide_one_by_one(fcl_partners, one_by_one);
    check_equal(lists, in_rows(both, 200));
    check_equal(lists, in_rows(one_by_one, 200));
  }
}

TEST_CASE("pairs within a moving set equal an all-pairs sweep and FCL's own", "[contact][broad_phase][Q12]") {
  MovingBoxes moving(200, 3);
  BroadPhase phase;
  FclBoxes fcl_boxes(moving.boxes());
  PairTable lists;
  for (int step = 0; step < 50; ++step, moving.step()) {
    const auto& boxes = moving.boxes();
    REQUIRE_FALSE(phase.update(boxes));
    phase.find_pairs([&](auto i, auto j) { return do_overlap(boxes[i], boxes[j]); }, lists);
    REQUIRE(lists.partners.size() > 10);
    check_equal(lists, sweep(boxes));
    fcl_boxes.update(boxes);
    std::vector<RowPartner> pairs;
    fcl_boxes.collide_self(pairs);
    check_equal(lists, in_rows(pairs, 200));
  }
}

TEST_CASE("what keep turns down is left out", "[contact][broad_phase]") {
  MovingBoxes moving(300, 4);
  BroadPhase phase;
  PairTable all = pairs_among(moving.boxes()), some;
  REQUIRE_FALSE(phase.update(moving.boxes()));
  phase.find_pairs([](auto i, auto j) { return i < j && (i + j) % 2 == 0; }, some);
  std::size_t n_even = 0;
  for (std::uint32_t row = 0; row < 300; ++row) {
    for (const std::uint32_t partner : all.of(row)) n_even += (row + partner) % 2 == 0;
  }
  CHECK(n_even > 0);
  CHECK(some.partners.size() == n_even);
  CHECK(phase.counts().candidates == n_even);
  CHECK(phase.counts().overlaps == all.partners.size());
}

TEST_CASE("lists are the same for one and two threads", "[contact][broad_phase][threads]") {
  MovingBoxes moving(20000, 5);
  std::vector<Box> boxes = moving.boxes();
  for (Box& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      box.hi[axis] = box.lo[axis] + 0.25 * (box.hi[axis] - box.lo[axis]);
  }
  const int n_before = omp_get_max_threads();
  omp_set_num_threads(1);
  const PairTable one = pairs_among(boxes), one_between = pairs_between(boxes, moving.boxes());
  omp_set_num_threads(2);
  const PairTable two = pairs_among(boxes), two_between = pairs_between(boxes, moving.boxes());
  omp_set_num_threads(n_before);
  CHECK(one.partners.size() > 20000);
  check_equal(two, one);
  check_equal(two_between, one_between);
}

TEST_CASE("sets of no box and of one box have the pairs they have", "[contact][broad_phase]") {
  const std::vector<Box> none, one = {{{0, 0, 0}, {1, 1, 1}}};
  check_equal(pairs_among(none), {{0}, {}});
  check_equal(pairs_among(one), {{0, 0}, {}});
  check_equal(pairs_between(none, one), {{0}, {}});
  check_equal(pairs_between(one, none), {{0, 0}, {}});
  check_equal(pairs_between(one, one), {{0, 1}, {0}});
}

TEST_CASE("a set may grow from nothing and shrink again", "[contact][broad_phase]") {
  const std::vector<Box> boxes(3, Box{{0, 0, 0}, {1, 1, 1}});
  BroadPhase phase;
  PairTable lists;
  for (const std::size_t n : {0u, 3u, 2u, 0u, 1u}) {
    REQUIRE_FALSE(phase.update(std::span(boxes).first(n)));
    phase.find_pairs(any, lists);
    CHECK(lists.n_rows() == n);
    CHECK(lists.partners.size() == (n > 0 ? n * (n - 1) / 2 : 0));
  }
}

TEST_CASE("boxes that all coincide all pair", "[contact][broad_phase]") {
  const Box box{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  const PairTable lists = pairs_among(std::vector<Box>(500, box));
  CHECK(lists.partners.size() == 500 * 499 / 2);
  CHECK(lists.of(0).size() == 499);
  const PairTable between = pairs_between({box}, std::vector<Box>(20000, box));
  CHECK(between.of(0).size() == 20000);
}

TEST_CASE("the first unsound box is reported, before a build and at a refit", "[contact][broad_phase]") {
  std::vector<Box> boxes(5, Box{{0, 0, 0}, {1, 1, 1}});
  BroadPhase phase;
  PairTable lists;
  REQUIRE_FALSE(phase.update(boxes));
  std::vector<Box> bad = boxes;
  bad[4].hi[2] = bad[2].lo[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(phase.update(bad) == 2u);
  CHECK(phase.counts().refits == 0);
  REQUIRE_FALSE(phase.update(boxes));
  phase.find_pairs(any, lists);
  CHECK(lists.partners.size() == 10);
  CHECK(BroadPhase().update(bad) == 2u);
}

TEST_CASE("a tree is built once, refitted while it serves, and built anew when it has grown slow",
          "[contact][broad_phase]") {
  MovingBoxes moving(2000, 6);
  BroadPhase phase;
  PairTable lists;
  for (int step = 0; step < 5; ++step) {
    REQUIRE_FALSE(phase.update(moving.boxes()));
    phase.find_pairs(any, lists);
  }
  CHECK(phase.counts().builds == 1);
  CHECK(phase.counts().refits == 4);
  CHECK(phase.counts().candidates == 5 * lists.partners.size());
  const std::uint64_t visits_in_place = phase.counts().visits / 5;
  for (int step = 0; step < 40; ++step) {
    moving.step();
    REQUIRE_FALSE(phase.update(moving.boxes()));
    phase.find_pairs(any, lists);
  }
  CHECK(phase.counts().builds > 2);
  CHECK(phase.counts().builds + phase.counts().refits == 45);
  CHECK(phase.counts().visits / 45 > visits_in_place);
}

TEST_CASE("bodies that come together from afar cost no more than a few builds", "[contact][broad_phase]") {
  const std::vector<Box> here = MovingBoxes(1000, 7).boxes();
  BroadPhase still, moving;
  PairTable lists;
  for (int step = 0; step <= 40; ++step) {
    std::vector<Box> there = MovingBoxes(1000, 8).boxes();
    for (Box& box : there) box.lo[0] += 2.0 - 0.05 * step, box.hi[0] += 2.0 - 0.05 * step;
    REQUIRE_FALSE(still.update(here));
    REQUIRE_FALSE(moving.update(there));
    still.find_pairs(moving, any, lists);
  }
  CHECK(lists.partners.size() > 100);
  CHECK(still.counts().builds <= 5);
  CHECK(moving.counts().builds <= 5);
}
