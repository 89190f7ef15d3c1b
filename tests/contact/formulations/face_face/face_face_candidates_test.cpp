// SPDX-License-Identifier: BSD-3-Clause
// The candidates of faces, and what is remembered of them from search to search and over deaths.
#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_death.hpp"
#include "support/contact_faces.hpp"
#include "support/cube_on_plate.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// The element of the plate below the cube, the one beside it in x, and the cube.
constexpr std::uint32_t below = 3, beside = 4, of_cube = 9;

const std::string hybrid_faces =
    "friction model = h\ncapture tolerance = 0.01\nend\n"
    "begin constant friction model rough\nfriction coefficient = 0.5\nend\n"
    "begin hybrid model h\ninitially close = rough\n";

FaceIndex bottom_of(const CubeOnPlate& parts) { return face_of(parts, of_cube, -Vector3d::UnitZ()); }
FaceIndex top_of(const CubeOnPlate& parts, std::uint32_t element) {
  return face_of(parts, element, Vector3d::UnitZ());
}

}  // namespace

TEST_CASE("pairs that leave the candidates are forgotten", "[contact][face_face_contacts]") {
  CubeOnPlate parts;
  parts.move_cube({0, 0, -0.4}, false);
  CHECK(!parts.find().empty());
  parts.move_cube({0, 0, -0.2}, false);
  parts.renew_candidates();
  CHECK(!parts.find().empty());
  parts.contacts.take_candidates({});
  CHECK(parts.find().empty());
  parts.renew_candidates();
  CHECK(parts.find().empty());  // as deep as before, but not known any more
}

TEST_CASE("bounds are needed of the faces that have candidates, and of no others",
          "[contact][face_face_contacts]") {
  CubeOnPlate parts;
  IndexedVector<FaceIndex, std::uint8_t> is_watched(parts.contact_mesh.faces.size(), 0);
  parts.contacts.watch(is_watched);
  CHECK(is_watched[bottom_of(parts)] == 1);
  CHECK(is_watched[top_of(parts, below)] == 1);
  CHECK(is_watched[face_of(parts, of_cube, Vector3d::UnitZ())] == 0);
  CHECK(is_watched[face_of(parts, 8, Vector3d::UnitZ())] == 0);  // two cells away
  for (const FaceIndex face : indices(parts.contact_mesh.faces)) {
    bool is_candidate = false;
    for (const FaceIndex row : parts.face_partners.rows()) {
      for (const FaceIndex partner : parts.face_partners.of(row))
        is_candidate = is_candidate || row == face || partner == face;
    }
    CHECK((is_watched[face] == 1) == is_candidate);
  }
}

TEST_CASE("faces that are left after a death go on as deep and with the slip that they had",
          "[contact][face_face_contacts]") {
  const std::string rough =
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 50\n";
  CubeOnPlate parts(rough);
  parts.move_cube({0, 0, -0.3});
  REQUIRE(parts.find().size() == 1);
  parts.move_cube({0.01, 0, -0.4});
  REQUIRE(parts.find().size() == 1);
  // The first cell dies: faces behind it have other numbers, and new ones show inside.
  const FaceIndex before = bottom_of(parts);
  const ContactRemap remap = let_die(parts, general_contact("penalty stiffness = 1000\n" + rough), {1});
  parts.contacts.remap(remap);
  CHECK(bottom_of(parts).value != before.value);
  CHECK(parts.contacts.n_rows() == parts.contact_mesh.faces.size());
  parts.move_cube({0.01, 0, 0});
  const auto points = parts.find();
  REQUIRE(points.size() == 1);
  CHECK(points[0].first_face() == top_of(parts, below));
  CHECK(points[0].second_face() == bottom_of(parts));
  CHECK(points[0].gap == Approx(-0.7));  // deeper than what begins to touch may be
  CHECK(points[0].elastic_slip.x() == Approx(-0.02));
}

TEST_CASE("of a HYBRID pair the faces that lie over each other within the tolerance are close",
          "[contact][face_face_contacts]") {
  const double height = GENERATE(0.005, 0.05);
  CubeOnPlate parts(hybrid_faces);
  parts.move_cube({0, 0, height}, false);
  parts.contacts.mark_close(parts.context(), 0.05, parts.rules);
  const auto friction_with = [&](std::uint32_t element) {
    return parts.rules.of_faces({0}, top_of(parts, element), bottom_of(parts)).friction;
  };
  CHECK(friction_with(below) == (height < 0.01 ? 0.5 : 0.0));
  CHECK(friction_with(beside) == 0.0);
}

TEST_CASE("both faces of a pair that has to know its start get the gap between them",
          "[contact][face_face_contacts]") {
  CubeOnPlate parts("initial clearance = 0.01\n");
  parts.move_cube({0.55, 0, 0.02}, false);  // over two cells, 0.25 of it on the first
  parts.renew_candidates();
  FoundStartGaps gaps;
  parts.contacts.add_start_gaps(parts.context(), gaps);
  CHECK(gaps.nodes.empty());
  CHECK(gaps.edges.empty());
  REQUIRE(gaps.faces.size() == 4);
  const std::array<std::uint32_t, 4> entities{top_of(parts, below).value, bottom_of(parts).value,
                                              top_of(parts, beside).value, bottom_of(parts).value};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(gaps.faces[i].entity == entities[i]);
    CHECK(gaps.faces[i].pair == PairIndex{0});
    CHECK(gaps.faces[i].mean == Approx(0.02));
    CHECK(gaps.faces[i].area == Approx(0.5 * 0.25));
  }
  CubeOnPlate other;
  FoundStartGaps none;
  other.contacts.add_start_gaps(other.context(), none);
  CHECK(none.faces.empty());
}

TEST_CASE("faces that slide infinitesimally stay candidates wherever they go",
          "[contact][face_face_contacts]") {
  const bool is_small = GENERATE(true, false);
  CubeOnPlate parts(is_small ? "interaction behavior = infinitesimal_sliding\n" : "");
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  const auto find = [&] {
    parts.contacts.find_candidates(search, parts.kinematics, parts.motion());
    search.finish(parts.kinematics);
  };
  find();
  const auto has = [&](std::uint32_t element) {
    return std::ranges::binary_search(parts.contacts.candidates().of(top_of(parts, element)),
                                      bottom_of(parts));
  };
  CHECK(has(below));
  CHECK(has(beside) == false);
  parts.move_cube({1.5, 0, 0}, false);
  find();
  CHECK(has(below) == is_small);
  CHECK(has(beside) == !is_small);
}
