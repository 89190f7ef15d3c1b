// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/face_face/face_pair_bounds.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A brick of quadrilaterals and one of triangles, of a size, with nodes that are moved at random.
struct BrickPair : ContactParts {
  explicit BrickPair(double length) : ContactParts(made(length), general_contact()), size(length), start(x) {}
  static MeshBuilder made(double length) {
    MeshBuilder b;
    b.add_hexes({.id = 1, .size = {length, length, length}});
    b.add_tets({.id = 2, .size = {length, 2 * length, length}, .share_nodes = false});
    return b;
  }
  void throw_at_random(Random& random, double warp, double far) {
    const Eigen::Matrix3d turn = random_rotation(random);
    const Vector3d way = size * random_vector(random, 1.6);
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      x.col(i) = start.col(i) + size * random_vector(random, warp);
      v.col(i) = size * random_vector(random, 3.0);
    }
    x.rightCols(8) = ((turn * x.rightCols(8)).colwise() + way).eval();
    x.colwise() += far * Vector3d(1, -2, 3);
    move();
  }

  double size;
  Eigen::Matrix3Xd start;
};

/// may_touch() of the bounds of two faces, one pair at a time.
bool may_touch_alone(const ContactKinematics& kinematics, FaceIndex first, FaceIndex second, double ahead,
                     double reach) {
  const FaceBound &a = kinematics.bound(first), &b = kinematics.bound(second);
  const float closing = std::max(0.0f, (b.velocity() - a.velocity()).dot(b.normal()));
  return may_touch(a, b, static_cast<double>(closing) * ahead + reach);
}

}  // namespace

TEST_CASE("pairs of faces together may touch where each alone may, and hardly more often",
          "[contact][face_pair_bounds]") {
  const double size = GENERATE(1.0, 1e-6, 1e4), warp = GENERATE(0.0, 0.15);
  const double reach = GENERATE(0.0, 0.2) * size, ahead = GENERATE(0.0, 0.05);
  Random random(5);
  BrickPair parts(size);
  FacePairBounds bounds;
  const IndexRange<FaceIndex> first_faces({0}, {6}), second_faces({6}, {18});
  REQUIRE(parts.contact_mesh.faces.size() == 18);
  int n_alone = 0, n_together = 0, n_all = 0;
  for (int i = 0; i < 60; ++i) {
    parts.throw_at_random(random, warp, 0.0);
    bounds.update(parts.kinematics);
    FacePairBounds::Pairs pairs;
    const auto look = [&] {
      const std::uint32_t found = bounds.may_touch(pairs, ahead, reach);
      CHECK((found & ~pairs.all()) == 0);
      for (std::size_t lane = 0; lane < pairs.n; ++lane) {
        const bool together = (found >> lane & 1) != 0;
        const bool alone =
            may_touch_alone(parts.kinematics, pairs.first[lane], pairs.second[lane], ahead, reach);
        if (alone && !together) FAIL("a pair that may touch is left out");
        n_alone += alone ? 1 : 0;
        n_together += together ? 1 : 0;
        ++n_all;
      }
      pairs.n = 0;
    };
    for (const FaceIndex first : first_faces) {
      for (const FaceIndex second : second_faces) {
        pairs.add(first, second, 0);
        if (pairs.n == 1 + static_cast<std::size_t>(i) % n_float_lanes) look();
      }
    }
    look();
  }
  CHECK(n_alone > 100);
  CHECK(n_together < n_all / 2);
  if (warp == 0.0) CHECK(n_together < 3 * n_alone);
}

TEST_CASE("pairs of faces far from the origin, and far from each other, are left out by no rounding",
          "[contact][face_pair_bounds]") {
  Random random(6);
  BrickPair parts(1.0);
  FacePairBounds bounds;
  int n_alone = 0;
  for (int i = 0; i < 100; ++i) {
    parts.throw_at_random(random, 0.1, 1e7);
    // A node of another face may be very far off, so that the origin is.
    parts.x.col(0) += Vector3d(1e6, 0, 0);
    parts.move();
    bounds.update(parts.kinematics);
    for (std::uint32_t a = 0; a < 6; ++a) {
      for (std::uint32_t b = 6; b < 18; ++b) {
        FacePairBounds::Pairs pairs;
        pairs.add({a}, {b}, 0);
        const bool alone = may_touch_alone(parts.kinematics, {a}, {b}, 0.01, 0.05);
        if (alone && bounds.may_touch(pairs, 0.01, 0.05) == 0) FAIL("a pair that may touch is left out");
        n_alone += alone ? 1 : 0;
      }
    }
  }
  CHECK(n_alone > 100);
}

TEST_CASE("no pairs touch nothing", "[contact][face_pair_bounds]") {
  BrickPair parts(1.0);
  parts.move();
  FacePairBounds bounds;
  bounds.update(parts.kinematics);
  CHECK(bounds.may_touch({}, 0.0, 100.0) == 0);
  CHECK(bounds.bytes() == 18 * 64);
}
