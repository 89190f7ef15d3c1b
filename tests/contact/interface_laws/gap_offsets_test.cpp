// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/gap_offsets.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// One pair with the settings, and gaps of the start: face 3 with 0.02 and -0.01 over areas 3 and 1, face 5
/// with 0.04.
GapOffsets offsets_with(const GapSettings& gap, double time = 0.0) {
  SurfacePair pair;
  pair.gap = gap;
  GapOffsets offsets(std::span(&pair, 1));
  FoundStartGaps found;
  found.faces = {{3, 0, 0.02, 0.02, 3.0}, {5, 0, 0.04, 0.04, 1.0}, {3, 0, -0.01, -0.01, 1.0}};
  found.nodes = {{2, 0, -0.03, -0.03, 1.0}};
  offsets.set_start(found, time);
  return offsets;
}

}  // namespace

TEST_CASE("gaps of one face become their mean by area and their smallest", "[contact][gap_offsets]") {
  StartGaps gaps;
  gaps.set({{3, 1, 0.02, 0.02, 3.0}, {3, 0, 0.5, 0.5, 1.0}, {3, 1, -0.01, -0.01, 1.0}});
  REQUIRE(gaps.find(3, {1}) != nullptr);
  CHECK(gaps.find(3, {1})->mean == Approx((3.0 * 0.02 - 0.01) / 4.0));
  CHECK(gaps.find(3, {1})->smallest == -0.01);
  CHECK(gaps.find(3, {0})->mean == 0.5);
  CHECK(gaps.find(3, {2}) == nullptr);
  CHECK(gaps.find(2, {1}) == nullptr);
  CHECK(gaps.find(900, {1}) == nullptr);
  CHECK(StartGaps().find(0, {0}) == nullptr);
}

TEST_CASE("without settings nothing is taken off", "[contact][gap_offsets]") {
  const GapOffsets offsets = offsets_with({});
  CHECK_FALSE(offsets.needs_start());
  CHECK(offsets.of_faces({0}, {3}, {5}) == 0.0);
  CHECK(offsets.of_node({0}, {2}) == 0.0);
  CHECK(offsets.reach({0}) == 0.0);
}

TEST_CASE("a clearance takes off what the gap of the start had more", "[contact][gap_offsets]") {
  const GapOffsets offsets = offsets_with({{}, 0.005, {}, {}});
  const double of_3 = (3.0 * 0.02 - 0.01) / 4.0 - 0.005, of_5 = 0.04 - 0.005;
  CHECK(offsets.of_faces({0}, {3}, {9}) == Approx(of_3));
  CHECK(offsets.of_faces({0}, {9}, {3}) == Approx(of_3));
  CHECK(offsets.of_faces({0}, {3}, {5}) == Approx(0.5 * (of_3 + of_5)));
  CHECK(offsets.of_faces({0}, {8}, {9}) == 0.0);
  CHECK(offsets.of_node({0}, {2}) == Approx(-0.035));
  CHECK(offsets.reach({0}) == Approx(of_5));
  CHECK(offsets.largest_reach() == Approx(of_5));
}

TEST_CASE("an ignored overlap is taken off at its deepest, on top of the offset", "[contact][gap_offsets]") {
  const GapOffsets offsets = offsets_with({0.002, {}, true, {}});
  CHECK(offsets.of_faces({0}, {3}, {9}) == Approx(-0.01));
  CHECK(offsets.of_faces({0}, {5}, {9}) == Approx(0.002));
  CHECK(offsets.of_node({0}, {2}) == Approx(-0.03));
  CHECK(offsets.of_node({0}, {1}) == Approx(0.002));
}

TEST_CASE("a ramp takes off less and less, from the start of the run on", "[contact][gap_offsets]") {
  GapOffsets offsets = offsets_with({{}, {}, {}, 2.0}, 10.0);
  CHECK(offsets.of_node({0}, {2}) == Approx(-0.03));
  offsets.activate(10.5);
  CHECK(offsets.of_node({0}, {2}) == Approx(-0.0225));
  CHECK(offsets.ramp_progress({0}) == Approx(0.25));
  offsets.activate(11.0);
  CHECK(offsets.ramp_progress({0}) == Approx(0.25));
  offsets.activate(14.0);
  CHECK(offsets.of_node({0}, {2}) == 0.0);
  CHECK(offsets.ramp_progress({0}) == Approx(0.5));
  ContactPoint point;
  point.first_entity = 2;
  CHECK(offsets.ramped_depth(point) == Approx(0.03));
}

TEST_CASE("gaps of the start go over to new numbers, and are gone with what had them",
          "[contact][gap_offsets]") {
  GapOffsets offsets = offsets_with({{}, {}, true, {}});
  ContactRemap remap;
  remap.faces.resize(6);
  remap.faces[{3}] = FaceIndex{1};
  remap.rows.resize(3);
  offsets.remap(remap);
  CHECK(offsets.of_faces({0}, {1}, {9}) == Approx(-0.01));
  CHECK(offsets.of_faces({0}, {3}, {5}) == 0.0);
  CHECK(offsets.of_node({0}, {2}) == 0.0);
}
