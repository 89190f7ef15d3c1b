// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_face_history.hpp"

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Two pairs of faces, 0 with 7 and 1 with 7, and what is remembered of them.
struct RememberedFaces {
  ContactParts parts{cube_over_cube(0.0),
                     general_contact("friction model = rough\nend\nbegin constant friction model rough\n"
                                     "friction coefficient = 0.2\n")};
  FacePairLists candidates = list_by_row<FaceIndex, FaceIndex>(12, [](const auto& take) {
    take(FaceIndex{0}, FaceIndex{7});
    take(FaceIndex{1}, FaceIndex{7});
  });
  FaceFaceHistory history{true, true};

  RememberedFaces() {
    history.transfer(list_by_row<FaceIndex, FaceIndex>(12, [](const auto&) {}), candidates);
  }
  static ContactPoint point(std::uint32_t first, double gap, double area = 1.0,
                            const Vector3d& elastic_slip = Vector3d::Zero()) {
    ContactPoint made;
    made.first_entity = first;
    made.second_entity = 7;
    made.first.weights = Eigen::Vector4d(0.7, 0.1, 0.1, 0.1);
    made.second.weights = Eigen::Vector4d(0.1, 0.1, 0.7, 0.1);
    made.force = gap < 0.0 ? 1.0 : 0.0;
    made.gap = gap;
    made.area = area;
    made.elastic_slip = elastic_slip;
    return made;
  }
  /// A step, and the begin of the next one.
  void step(const std::vector<ContactPoint>& points) {
    history.begin_step(candidates, parts.contact_mesh.faces.size());
    history.update(parts.context(0.1), candidates, points);
    history.begin_step(candidates, parts.contact_mesh.faces.size());
  }
};

using Remembered = RememberedFaces;

}  // namespace

TEST_CASE("pairs of faces that touched are known in the next step, and not in the one after",
          "[contact][face_face_history]") {
  Remembered faces;
  faces.step({Remembered::point(0, -0.1, 1.0, {1, 2, 0}), Remembered::point(1, 0.1)});
  CHECK(faces.history.has_touched(0));
  CHECK_FALSE(faces.history.has_touched(1));
  CHECK(faces.history.elastic_slip(0) == Vector3d(1, 2, 0));
  CHECK(faces.history.elastic_slip(1).isZero(0.0));
  faces.step({});
  CHECK_FALSE(faces.history.has_touched(0));
  CHECK(faces.history.elastic_slip(0).isZero(0.0));
}

TEST_CASE("facets of one pair hold the mean of their slips by area", "[contact][face_face_history]") {
  Remembered faces;
  faces.step({Remembered::point(0, -0.1, 1.0, {1, 0, 0}), Remembered::point(0, -0.2, 3.0, {5, 4, 0})});
  CHECK(faces.history.elastic_slip(0).isApprox(Vector3d(4, 3, 0)));
}

TEST_CASE("faces know their mean slip as each sees it", "[contact][face_face_history]") {
  Remembered faces;
  faces.step({Remembered::point(0, -0.1, 1.0, {1, 0, 0}), Remembered::point(1, -0.1, 3.0, {5, 0, 0})});
  CHECK(faces.history.mean_slip({0}, {5}).isApprox(Vector3d(1, 0, 0)));
  CHECK(faces.history.mean_slip({7}, {5}).isApprox(Vector3d(-4, 0, 0)));
  CHECK(faces.history.mean_slip({5}, {7}).isApprox(Vector3d(4, 0, 0)));  // by the second face
  CHECK(faces.history.mean_slip({5}, {6}).isZero(0.0));
}

TEST_CASE("faces know how deep they were in whatever they touched", "[contact][face_face_history]") {
  Remembered faces;
  CHECK(faces.history.depth_before({0}, {7}) == 0.0);  // before the first step
  faces.step({Remembered::point(0, -0.125), Remembered::point(1, -0.25)});
  CHECK(faces.history.depth_before({0}, {5}) == 0.125);
  CHECK(faces.history.depth_before({0}, {7}) == 0.25);
  CHECK(faces.history.depth_before({7}, {0}) == 0.25);
  CHECK(faces.history.depth_before({4}, {5}) == 0.0);
  // What touches without depth has more than none.
  ContactPoint pulled = Remembered::point(0, 0.1);
  pulled.pulls = true;
  faces.step({pulled});
  CHECK(faces.history.depth_before({0}, {5}) > 0.0);
}

TEST_CASE("contacts that ended deep are lost, once and by the deeper of both faces",
          "[contact][face_face_history]") {
  Remembered faces;
  std::vector<LostContact> lost;
  const auto find = [&] {
    lost.clear();
    faces.history.find_lost(faces.parts.contact_mesh, faces.parts.rules, lost);
    return lost.size();
  };
  faces.step({Remembered::point(0, -0.6)});  // of elements of 1
  REQUIRE(find() == 1);
  CHECK(lost[0].pair == PairIndex{0});
  CHECK(lost[0].node == faces.parts.contact_mesh.faces[{0}].corners[0]);
  CHECK(lost[0].depth == Approx(0.6));
  faces.step({});
  CHECK(find() == 0);
  faces.step({Remembered::point(0, -0.4)});  // not deep
  CHECK(find() == 0);
}

TEST_CASE("a contact that goes on elsewhere on either face is not lost", "[contact][face_face_history]") {
  Remembered faces;
  faces.step({Remembered::point(0, -0.6)});
  faces.history.update(faces.parts.context(0.1), faces.candidates, std::vector{Remembered::point(1, -0.6)});
  std::vector<LostContact> lost;
  faces.history.find_lost(faces.parts.contact_mesh, faces.parts.rules, lost);
  CHECK(lost.empty());
}

TEST_CASE("a step that is undone is as if it had not begun", "[contact][face_face_history]") {
  Remembered faces;
  faces.step({Remembered::point(0, -0.125, 1.0, {1, 0, 0})});
  faces.history.undo_begin_step();
  REQUIRE(faces.history.depths().size() == 12);
  CHECK(faces.history.depths()[0] == 0.125f);
  faces.history.begin_step(faces.candidates, 12);
  CHECK(faces.history.has_touched(0));
  CHECK(faces.history.mean_slip({0}, {5}).isApprox(Vector3d(1, 0, 0)));
}

TEST_CASE("what is known goes over to other candidates and other faces", "[contact][face_face_history]") {
  Remembered faces;
  faces.history.begin_step(faces.candidates, 12);
  faces.history.update(faces.parts.context(0.1), faces.candidates,
                       std::vector{Remembered::point(1, -0.125, 1.0, {1, 0, 0})});
  const FacePairLists now = list_by_row<FaceIndex, FaceIndex>(12, [](const auto& take) {
    take(FaceIndex{0}, FaceIndex{6});
    take(FaceIndex{0}, FaceIndex{7});
    take(FaceIndex{1}, FaceIndex{7});
  });
  faces.history.transfer(faces.candidates, now);
  // Then face 0 dies, with its candidates.
  ContactRemap remap;
  remap.n_faces_after = 11;
  remap.faces.push_back(std::nullopt);
  for (std::uint32_t i = 1; i < 12; ++i) remap.faces.push_back(FaceIndex{i - 1});
  const std::vector<std::size_t> before{2};
  faces.history.remap(remap, before);
  const FacePairLists after =
      list_by_row<FaceIndex, FaceIndex>(11, [](const auto& take) { take(FaceIndex{0}, FaceIndex{6}); });
  faces.history.begin_step(after, 11);
  CHECK(faces.history.has_touched(0));
  CHECK(faces.history.elastic_slip(0) == Vector3d(1, 0, 0));
  CHECK(faces.history.depth_before({0}, {3}) == 0.125);
  CHECK(faces.history.mean_slip({0}, {3}).isApprox(Vector3d(1, 0, 0)));
  std::vector<LostContact> lost;
  faces.history.find_lost(faces.parts.contact_mesh, faces.parts.rules, lost);
  CHECK(lost.empty());
}

TEST_CASE("what is known goes on from a stored state", "[contact][face_face_history]") {
  Remembered faces;
  faces.history.begin_step(faces.candidates, 12);
  faces.history.update(faces.parts.context(0.1), faces.candidates,
                       std::vector{Remembered::point(1, -0.6, 1.0, {1, 0, 0})});
  StateArchive saves;
  faces.history.archive(saves);
  const SavedState saved = saves.take();
  FaceFaceHistory other(true, true);
  StateArchive restores(saved);
  other.archive(restores);
  other.begin_step(faces.candidates, 12);
  CHECK(other.has_touched(1));
  CHECK(other.elastic_slip(1) == Vector3d(1, 0, 0));
  CHECK(other.mean_slip({1}, {3}) == Vector3d(1, 0, 0));
  CHECK(other.depth_before({1}, {3}) == Approx(0.6));
  std::vector<LostContact> lost;
  other.find_lost(faces.parts.contact_mesh, faces.parts.rules, lost);
  CHECK(lost.size() == 1);
}
