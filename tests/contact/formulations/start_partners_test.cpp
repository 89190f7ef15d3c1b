// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/start_partners.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::ContactParts;

namespace {

MovingFace flat_quad() {
  MovingFace face;
  face.x << 0, 2, 3, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  face.v << 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 4;
  return face;
}

/// A cube of 2 x 2 x 2 on another one, whose nodes, or faces, slide infinitesimally.
struct SlidingCubes : ContactParts {
  explicit SlidingCubes(const std::string& more = "")
      : ContactParts(test::stacked_cubes(0.0, 2),
                     "skin all blocks = on\nbegin interaction\nside a = block_1\nside b = block_2\n"
                     "interaction behavior = infinitesimal_sliding\n" +
                         more + "end\n") {
    search();
  }
  bool is_top(FaceIndex face) const {
    return contact_mesh.faces[face].surface == SurfaceIndex{0} &&
           kinematics.area(contact_mesh.faces[face]).normalized().z() > 0.9;
  }
};

}  // namespace

TEST_CASE("nodes that slide keep the faces that they stand over, and no others",
          "[contact][start_partners]") {
  const SlidingCubes cubes(test::node_face);
  StartPartners<SurfaceNodeIndex> partners;
  partners.begin_nodes(cubes.kinematics, cubes.rules, cubes.node_faces);
  REQUIRE_FALSE(partners.empty());
  std::size_t n_kept = 0;
  for (const SurfaceNodeIndex row : cubes.node_faces.rows()) {
    for (const FaceIndex face : cubes.node_faces.of(row)) {
      if (!partners.has(row, face)) continue;
      ++n_kept;
      CHECK(cubes.is_top(face));
      CHECK(cubes.contact_mesh.surface_nodes[row].surface == SurfaceIndex{1});
    }
  }
  CHECK(n_kept == 16);  // the middle node of four faces, four of two, four of one
  NodeFaceLists nothing;
  nothing.begin.assign(cubes.node_faces.n_rows() + 1, 0);
  CHECK(partners.united_with(cubes.rules, nothing).partners.size() == 16);
}

TEST_CASE("nodes are released when the last of their faces is dead", "[contact][start_partners]") {
  const SlidingCubes cubes(test::node_face);
  StartPartners<SurfaceNodeIndex> partners;
  partners.begin_nodes(cubes.kinematics, cubes.rules, cubes.node_faces);
  const auto stay = [](auto& positions, std::size_t n) {
    positions.resize(n);
    for (const auto i : indices(positions)) positions[i] = i;
  };
  const ContactMesh& mesh = cubes.contact_mesh;
  NewPositions<SurfaceNodeIndex> rows;
  NewPositions<FaceIndex> faces;
  stay(rows, mesh.surface_nodes.size());
  stay(faces, mesh.faces.size());
  CHECK(partners.remap(rows, faces, rows.size()).empty());
  FaceIndex dead;  // the first face on top
  while (!cubes.is_top(dead)) ++dead.value;
  faces[dead] = std::nullopt;
  CHECK(partners.remap(rows, faces, rows.size()).size() == 1);  // the node at the corner of the cubes
  for (const FaceIndex face : indices(faces)) {
    if (cubes.is_top(face)) faces[face] = std::nullopt;
  }
  CHECK(partners.remap(rows, faces, rows.size()).size() == 8);
  CHECK(partners.empty());
}

TEST_CASE("faces that slide keep the faces that they lie over, carried along", "[contact][start_partners]") {
  SlidingCubes cubes;
  StartPartners<FaceIndex> partners;
  partners.begin_faces(cubes.kinematics, cubes.rules, cubes.face_partners);
  std::size_t n_kept = 0;
  const Vector3d way(0.1, -0.05, 0.02);
  for (Eigen::Index i = 0; i < cubes.x.cols(); ++i) {
    if (i >= cubes.x.cols() / 2) cubes.x.col(i) += way;
  }
  cubes.move();
  for (const FaceIndex first : cubes.face_partners.rows()) {
    for (const FaceIndex second : cubes.face_partners.of(first)) {
      const auto carry = partners.find_carry(cubes.kinematics, first, second);
      CHECK(carry.has_value() == partners.has(first, second));
      if (!carry) continue;
      ++n_kept;
      const MovingFace still = cubes.kinematics.face(carry->is_of_first ? first : second);
      CHECK((still.x * carry->weights).norm() == Approx(std::hypot(0.1, 0.05)));  // in its own plane
    }
  }
  CHECK(n_kept == 4);
}

TEST_CASE("a face is carried with the velocities that belong there", "[contact][start_partners]") {
  PartnerCarry carry;
  CHECK(carry.is_zero());
  carry.weights = {-0.5, 0.5, 0.25, -0.25};
  const MovingFace face = flat_quad(), carried = carry.carried(face);
  const Vector3d way = face.x * carry.weights, faster = face.v * carry.weights;
  for (Eigen::Index k = 0; k < 4; ++k) {
    CHECK((carried.x.col(k) - face.x.col(k) - way).norm() < 1e-14);
    CHECK((carried.v.col(k) - face.v.col(k) - faster).norm() < 1e-14);
  }
}
