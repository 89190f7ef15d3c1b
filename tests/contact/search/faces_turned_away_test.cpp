// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/faces_turned_away.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A cube above a plate, as far as boxes hardly notice.
MeshBuilder cube_above_plate() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 1}, .size = {4, 4, 1}});
  b.add_hexes({.id = 2, .origin = {1.4, 1.4, 1.1}, .share_nodes = false});
  return b;
}

/// Turns the cube about an axis through its middle.
void turn_cube(ContactParts& parts, const Vector3d& axis, double angle) {
  auto cube = parts.x.rightCols(8);
  const Vector3d middle = cube.rowwise().mean();
  cube = (Eigen::AngleAxisd(angle, axis).matrix() * (cube.colwise() - middle)).colwise() + middle;
  parts.move();
}

double cosine_of(const ContactParts& parts, FaceIndex a, FaceIndex b) {
  return area_vector(parts.kinematics.face(a).x)
      .normalized()
      .dot(area_vector(parts.kinematics.face(b).x).normalized());
}

FaceIndex face_that_looks(const ContactParts& parts, std::uint32_t surface, const Vector3d& way) {
  for (const FaceIndex face : indices(parts.contact_mesh.faces)) {
    if (parts.contact_mesh.faces[face].surface.value == surface &&
        area_vector(parts.kinematics.face(face).x).normalized().dot(way) > 0.999)
      return face;
  }
  throw std::logic_error("no face looks there");
}

}  // namespace

TEST_CASE("faces that stand beside each other are turned away, opposite ones are not", "[contact][search]") {
  ContactParts parts(cube_above_plate(), general_contact());
  parts.move();
  FacesTurnedAway away;
  away.begin(parts.kinematics);
  const FaceIndex top = face_that_looks(parts, 0, Vector3d::UnitZ());
  const FaceIndex below = face_that_looks(parts, 1, -Vector3d::UnitZ());
  const FaceIndex side = face_that_looks(parts, 1, Vector3d::UnitX());
  const FaceIndex above = face_that_looks(parts, 1, Vector3d::UnitZ());
  CHECK_FALSE(away.are(parts.kinematics, top, below));
  CHECK(away.are(parts.kinematics, top, side));
  CHECK(away.are(parts.kinematics, above, top));
}

TEST_CASE("a watched face has turned when its normal has by more than 0.08, others may do so",
          "[contact][search]") {
  ContactParts parts(cube_above_plate(), general_contact());
  parts.move();
  FacesTurnedAway away;
  away.begin(parts.kinematics);
  const bool is_watched = GENERATE(true, false);
  // The top looks along the axis of the turn: it never turns.
  if (is_watched)
    CHECK(away.are(parts.kinematics, face_that_looks(parts, 0, Vector3d::UnitZ()),
                   face_that_looks(parts, 1, Vector3d::UnitX())));
  away.finish(parts.kinematics);
  turn_cube(parts, Vector3d::UnitZ(), 0.079);
  CHECK(away.room(parts.kinematics) > 0.0);
  turn_cube(parts, Vector3d::UnitZ(), 0.002);
  CHECK((away.room(parts.kinematics) < 0.0) == is_watched);
  away.begin(parts.kinematics);
  away.finish(parts.kinematics);
  CHECK(away.room(parts.kinematics) > 0.0);
}

TEST_CASE("a warped face is turned away only if its facets are", "[contact][search]") {
  ContactParts parts(cube_above_plate(), general_contact());
  parts.move();
  const FaceIndex top = face_that_looks(parts, 0, Vector3d::UnitZ());
  const FaceIndex side = face_that_looks(parts, 1, Vector3d::UnitX());
  // Corners go out and in by turns; facets lean by some 0.4.
  const auto corners = parts.contact_mesh.faces[side].corners;
  for (std::size_t k = 0; k < 4; ++k)
    parts.x(0, number_of(parts.contact_mesh.mesh_nodes[corners[k]])) += k % 2 == 0 ? 0.15 : -0.15;
  parts.move();
  FacesTurnedAway away;
  away.begin(parts.kinematics);
  CHECK(std::abs(cosine_of(parts, top, side)) < 1e-9);
  CHECK_FALSE(away.are(parts.kinematics, top, side));
}

TEST_CASE("no face comes to face what is no candidate of it, whichever way a cube turns",
          "[contact][search]") {
  const Vector3d axis = GENERATE(Vector3d(1, 0, 0), Vector3d(1, 1, 0), Vector3d(0.2, 1, 0.3));
  ContactParts parts(cube_above_plate(), general_contact());
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.move();
  int n_facing = 0;
  for (int step = 0; step < 150; ++step) {
    if (search.is_due(parts.kinematics)) parts.find_candidates(search);
    for (const FaceIndex top : parts.contact_mesh.faces_of({0})) {
      for (const FaceIndex of_cube : parts.contact_mesh.faces_of({1})) {
        if (cosine_of(parts, top, of_cube) > max_facing_cosine) continue;
        const MovingFace a = parts.kinematics.face(top), b = parts.kinematics.face(of_cube);
        if (!(find_face_face_contact(a, b, {1.0, 0.0, 0.5, {}}, 0.0).force > 0.0)) continue;
        ++n_facing;
        if (!std::ranges::binary_search(parts.face_partners.of(top), of_cube)) FAIL("a pair is lost");
      }
    }
    turn_cube(parts, axis.normalized(), 0.05);
  }
  CHECK(n_facing > 20);
  CHECK(search.n_searches() < 120);
}
