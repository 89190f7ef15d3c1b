// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_face.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "contact/geometry/facets.hpp"
#include "contact/geometry/projected_pair.hpp"
#include "core/interface_laws/pressure_law.hpp"
#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

constexpr double far = 1.0;
const PairPenalty stiff{1000.0, 0.0, far, {}};

/// A unit square under one of the same size that is shifted along x and lowered by a depth.
FaceFaceContact press(double depth, double shift, const PairPenalty& penalty = stiff, double reach = 0.0) {
  return find_face_face_contact(make_square(0.0, 0.0, true), make_square(shift, -depth, false), penalty,
                                reach);
}

/// The height of a triangle's plane at a place inside it.
std::optional<double> height_at(const FaceCorners& triangle, const Eigen::Vector2d& entity) {
  Eigen::Matrix2d sides;
  sides << triangle.col(1).head<2>() - triangle.col(0).head<2>(),
      triangle.col(2).head<2>() - triangle.col(0).head<2>();
  const Eigen::Vector2d share = sides.inverse() * (entity - triangle.col(0).head<2>());
  if (share.minCoeff() < 0.0 || share.sum() > 1.0) return std::nullopt;
  const double z = triangle(2, 0);
  return z + share[0] * (triangle(2, 1) - z) + share[1] * (triangle(2, 2) - z);
}

/// The net force and the net moment about the origin of what two faces get.
struct Balance {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  double size = 0.0;

  Balance(const MovingFace& a, const MovingFace& b, const FaceFaceContact& contact) {
    add(a, contact.weights_1, contact.force * contact.normal);
    add(b, contact.weights_2, -contact.force * contact.normal);
  }
  void add(const MovingFace& face, const Eigen::Vector4d& weights, const Vector3d& f) {
    for (int k = 0; k < 4; ++k) {
      force += weights[k] * f;
      moment += face.x.col(k).cross(weights[k] * f);
      size += std::abs(weights[k]) * f.norm();
    }
  }
};

}  // namespace

TEST_CASE("faces that overlap push each other by stiffness, area and depth", "[contact][face_face]") {
  const FaceFaceContact contact = press(0.01, 0.5);
  REQUIRE(contact.overlaps);
  CHECK(contact.force == Approx(1000.0 * 0.5 * 0.01));
  CHECK(contact.area == Approx(0.5));
  CHECK(contact.gap == Approx(-0.01));
  CHECK(contact.stiffness == Approx(500.0));
  CHECK((contact.normal - Vector3d(0, 0, -1)).norm() < 1e-15);
  // The middle of the overlap is at x = 0.75.
  CHECK((contact.weights_1 - Eigen::Vector4d(0.125, 0.375, 0.375, 0.125)).norm() < 1e-14);
  // The corners of the other are (0.5, 0), (0.5, 1), (1.5, 1), (1.5, 0).
  CHECK((contact.weights_2 - Eigen::Vector4d(0.375, 0.375, 0.125, 0.125)).norm() < 1e-14);
}

TEST_CASE("pressure over a tilted face is integrated exactly", "[contact][face_face]") {
  // The depth goes from 0.01 at x = 0 to 0.03 at x = 1 and is measured along the mean normal.
  MovingFace upper = make_square(0.0, -0.02, false);
  for (int k = 0; k < 4; ++k) upper.x(2, k) -= 0.02 * (upper.x(0, k) - 0.5);
  upper = make_face(upper.x);
  const MovingFace lower = make_square(0.0, 0.0, true);
  const FaceFaceContact contact = find_face_face_contact(lower, upper, stiff, 0.0);
  REQUIRE(contact.overlaps);
  CHECK(contact.force == Approx(1000.0 * 0.02).epsilon(1e-3));  // the slope squared
  // Centre of a pressure of 1 to 3: at x = 7/12. Mean square depth over mean depth: 13/6 of the least.
  CHECK(contact.weights_1[1] + contact.weights_1[2] == Approx(7.0 / 12.0).epsilon(1e-3));
  CHECK(contact.gap == Approx(-0.01 * 13.0 / 6.0).epsilon(1e-3));
}

TEST_CASE("a leaning face pushes by what of it lies behind the other one", "[contact][face_face]") {
  // It rises from x = 0 by 45 degrees: the part up to x = depth is behind the floor.
  MovingFace floor = make_square(-1.0, 0.0, true, 3.0);
  floor.x.row(1).array() -= 1.0;
  for (const double depth : {0.5, 0.01, 1e-6}) {
    MovingFace leaning = make_square(0.0, -depth, false);
    leaning.x.row(2) += leaning.x.row(0);
    leaning.sharpness = 1e9;
    const FaceFaceContact contact = find_face_face_contact(floor, leaning, stiff, 0.0);
    CHECK((contact.normal - Vector3d(0, 0, -1)).norm() < 1e-9);
    CHECK(contact.force == Approx(1000.0 * std::sqrt(2.0) * 0.5 * depth * depth).epsilon(1e-9));
    CHECK(contact.area == Approx(std::sqrt(2.0) * depth).epsilon(1e-9));
    CHECK(contact.gap == Approx(-2.0 / 3.0 * depth).epsilon(1e-9));
  }
}

namespace {

/// What a face that leans on a floor gives out on a closed path of depths and angles, over the sum of what
/// goes to and fro.
double work_of_path(double sharpness) {
  MovingFace floor = make_square(-2.0, 0.0, true, 5.0);
  floor.x.row(1).array() -= 2.0;
  const auto face_at = [&](double t) {
    MovingFace face = make_square(0.0, 0.0, false);
    const double angle = 0.8 + 0.2 * std::cos(t);
    face.x = Eigen::AngleAxisd(-angle, Vector3d::UnitY()).toRotationMatrix() * face.x;
    face.x.row(2).array() -= 0.2 + 0.1 * std::sin(t);
    face.sharpness = sharpness;
    return face;
  };
  constexpr int n = 400;
  double work = 0.0, size = 0.0;
  for (int i = 0; i < n; ++i) {
    const double t = 2.0 * M_PI * i / n, half = M_PI / n;
    const FaceFaceContact contact = find_face_face_contact(floor, face_at(t), stiff, 0.0);
    const FaceCorners way = face_at(t + half).x - face_at(t - half).x;
    const double share = -contact.force * contact.normal.dot(way * contact.weights_2);
    work += share;
    size += std::abs(share);
  }
  return work / size;
}

}  // namespace

TEST_CASE("a sharp edge that sinks in, tilts and comes back gives back what it took",
          "[contact][face_face]") {
  CHECK(std::abs(work_of_path(1e9)) < 1e-6);
  CHECK(std::abs(work_of_path(0.0)) > 0.05);  // as a face of a smooth surface, which does not lean so much
}

TEST_CASE("triangles push as a sum over fine squares says", "[contact][face_face]") {
  Random random(6);
  int n_parted = 0;
  for (int i = 0; i < 12; ++i) {
    const MovingFace a = random_face(random, true, true, 0.0), b = random_face(random, true, false, 0.0);
    const FaceFaceContact contact = find_face_face_contact(a, b, stiff, 0.0);
    const CommonPlane plane = make_common_plane(a.x, a.look(), b.look()).value();
    const ProjectedPair pair = project_pair(a, b).value();
    const FaceCorners &first = pair.first, &second = pair.second;
    double force = 0.0, touched = 0.0, shared = 0.0;
    constexpr int n = 400;
    for (int k = 0; k < n * n; ++k) {
      const Eigen::Vector2d entity(-1.5 + 3.0 * (k % n + 0.5) / n, -1.5 + 3.0 * (k / n + 0.5) / n);
      const auto z1 = height_at(first, entity), z2 = height_at(second, entity);
      if (!z1 || !z2) continue;
      const double depth = *z2 - *z1, area = plane.spread * 9.0 / (n * n);
      shared += area;
      touched += depth > 0.0 ? area : 0.0;
      force += stiff.stiffness * std::max(0.0, depth) * area;
    }
    n_parted += touched > 0.1 * shared && touched < 0.9 * shared ? 1 : 0;
    CHECK(contact.force == Approx(force).epsilon(0.02).margin(0.05));
    CHECK(contact.area == Approx(touched).margin(0.01));
  }
  CHECK(n_parted > 4);
}

TEST_CASE("faces of any shape get no net force and no net moment", "[contact][face_face]") {
  Random random(1);
  int n_touching = 0;
  for (int i = 0; i < 100; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, -0.05);
    const PairPenalty penalty{1000.0, i % 5 == 0 ? 30.0 : 0.0, far, {}};
    const FaceFaceContact contact = find_face_face_contact(a, b, penalty, 0.0);
    if (!(contact.force > 0.0)) continue;
    ++n_touching;
    const Balance balance(a, b, contact);
    CHECK(balance.force.norm() < 1e-14 * balance.size);
    CHECK(balance.moment.norm() < 1e-12 * balance.size);
  }
  CHECK(n_touching > 70);
}

TEST_CASE("forces do not depend on sides, frame or first corners", "[contact][face_face]") {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, -0.03);
    const PairPenalty penalty{1000.0, 20.0, far, {}};
    const FaceFaceContact contact = find_face_face_contact(a, b, penalty, 0.1),
                          swapped = find_face_face_contact(b, a, penalty, 0.1);
    REQUIRE(swapped.overlaps == contact.overlaps);
    CHECK(swapped.force == Approx(contact.force).margin(1e-10));
    CHECK(swapped.gap == Approx(contact.gap).margin(1e-13));
    CHECK((swapped.normal + contact.normal).norm() < 1e-14);
    CHECK((swapped.weights_1 - contact.weights_2).norm() < 1e-10);
    const Eigen::Matrix3d rotation = random_rotation(random);
    const Vector3d shift = random_vector(random, 5.0);
    const FaceFaceContact moved =
        find_face_face_contact(turned(a, rotation, shift), turned(b, rotation, shift), penalty, 0.1);
    CHECK(moved.force == Approx(contact.force).margin(1e-9));
    CHECK((moved.normal - rotation * contact.normal).norm() < 1e-12);
    CHECK((moved.weights_1 - contact.weights_1).norm() < 1e-9);
    CHECK(moved.damped_power == Approx(contact.damped_power).margin(1e-9));
  }
}

TEST_CASE("faces that count their corners from elsewhere push alike", "[contact][face_face]") {
  // The points of a polygon that is cut in two orders differ, and a warped face is no polynomial up here.
  Random random(3);
  int n_compared = 0;
  for (int i = 0; i < 20; ++i) {
    const MovingFace a = random_face(random, i % 2 == 0, true, 0.0),
                     b = random_face(random, i % 3 == 0, false, -0.4);
    const FaceFaceContact contact = find_face_face_contact(a, b, stiff, 0.0),
                          other = find_face_face_contact(renumbered(a), b, stiff, 0.0);
    if (contact.area < 0.1) continue;
    ++n_compared;
    CHECK(other.force == Approx(contact.force).epsilon(1e-2));
    CHECK(other.area == Approx(contact.area).epsilon(1e-12));
  }
  CHECK(n_compared > 10);
}

TEST_CASE("faces apart do not push; within the reach they count as near", "[contact][face_face]") {
  CHECK(press(-1e-12, 0.0).force == 0.0);
  CHECK(!press(-1e-12, 0.0).overlaps);
  const FaceFaceContact near = press(-0.05, 0.5, stiff, 0.1);
  CHECK(near.overlaps);
  CHECK(near.force == 0.0);
  CHECK(near.area == 0.0);
  CHECK(near.gap == Approx(0.05));
  CHECK(near.stiffness == Approx(500.0));
  CHECK((near.weights_1 - Eigen::Vector4d(0.125, 0.375, 0.375, 0.125)).norm() < 1e-14);
  CHECK(!press(-0.05, 0.5, stiff, 0.04).overlaps);
  CHECK(!press(0.01, 1.0).overlaps);
  CHECK(!press(0.01, 2.0).overlaps);
}

TEST_CASE("faces deeper in each other than the depth do not touch", "[contact][face_face]") {
  const PairPenalty shallow{1000.0, 0.0, 0.1, {}};
  CHECK(press(0.099, 0.0, shallow).force == Approx(99.0));
  CHECK(press(0.101, 0.0, shallow).force == 0.0);
  CHECK(!press(0.101, 0.0, shallow).overlaps);
}

TEST_CASE("damping pushes when faces close and never pulls", "[contact][face_face]") {
  const MovingFace lower = make_square(0.0, 0.0, true);
  const PairPenalty damped{1000.0, 2.0, far, {}};
  const auto at_speed = [&](double speed) {
    MovingFace upper = make_square(0.0, -0.01, false);
    upper.v.row(2).setConstant(speed);
    return find_face_face_contact(lower, upper, damped, 0.0);
  };
  CHECK(at_speed(-3.0).force == Approx(10.0 + 6.0));
  CHECK(at_speed(-3.0).damped_power == Approx(18.0));
  CHECK(at_speed(3.0).force == Approx(10.0 - 6.0));
  CHECK(at_speed(3.0).damped_power == Approx(18.0));
  CHECK(at_speed(30.0).force == Approx(0.0).margin(1e-14));
  CHECK(at_speed(30.0).damped_power == Approx(300.0));  // no more than the spring gives
}

TEST_CASE("the points of two faces tell the gap at each", "[contact][face_face]") {
  const auto found = find_face_face_points(make_square(0.0, 0.0, true), make_square(0.5, 0.2, false)).value();
  CHECK(found.points.area == Approx(0.5));
  CHECK((found.plane.normal - Vector3d(0, 0, -1)).norm() < 1e-15);
  for (int lane = 0; lane < n_lanes; ++lane) CHECK(found.points.all[0].gap(lane) == Approx(0.2));
  CHECK(find_face_face_points(make_square(0.0, 0.0, true), make_square(0.5, -0.2, false))
            ->points.all[0]
            .gap(0) == Approx(-0.2));
  CHECK(!find_face_face_points(make_square(0.0, 0.0, true), make_square(1.0, 0.2, false)));
  CHECK(!find_face_face_points(make_square(0.0, 0.0, true), make_square(0.0, 0.2, true)));
}

TEST_CASE("contacts of eight pairs are those of each pair alone, whatever their penalties",
          "[contact][face_face]") {
  Random random(21);
  const PressureLaw pressure = PressureLaw::exponential(10.0, 0.02);
  std::size_t n_contacts = 0, n_of_facets = 0;
  for (int i = 0; i < 30; ++i) {
    auto [first, second] = random_pairs(random, i, -0.1, 0.1);
    second[6] = first[6];  // looks the same way
    std::vector<PairPenalty> penalties;
    for (int k = 0; k < n_lanes; ++k) {
      penalties.push_back(stiff);
      penalties.back().damping = k % 2 == 0 ? 0.0 : 0.2 * k;
      if (k > 4) penalties.back().law = DepthLaw(0.01, 0.02, 5.0 + k);
      if (k == 3) penalties.back().pressure = &pressure;
      penalties.back().closing = 0.01 * k;
    }
    std::vector<PushedFaces> pairs;
    for (std::size_t k = 0; k < n_lanes; ++k)
      pairs.push_back({first[k], second[k], penalties[k], 0.01 * static_cast<double>(k),
                       i % 2 == 0 ? never_split : 0.02});
    std::vector<PushedContact> together, alone;
    find_face_face_contacts(pairs, together);
    for (std::size_t k = 0; k < n_lanes; ++k) {
      std::vector<PushedContact> one;
      find_face_face_contacts({&pairs[k], 1}, one);
      for (const PushedContact& of_one : one) alone.push_back({k, of_one.contact});
      n_of_facets += one.size() > 1 ? 1 : 0;
    }
    REQUIRE(together.size() == alone.size());
    n_contacts += alone.size();
    for (std::size_t k = 0; k < alone.size(); ++k) {
      const FaceFaceContact &a = together[k].contact, &b = alone[k].contact;
      CHECK(together[k].pair == alone[k].pair);
      CHECK(a.force == b.force);
      CHECK(a.gap == b.gap);
      CHECK(a.area == b.area);
      CHECK(a.stiffness == b.stiffness);
      CHECK(a.beyond_spring == b.beyond_spring);
      CHECK(a.damped_power == b.damped_power);
      CHECK(a.normal == b.normal);
      CHECK(a.weights_1 == b.weights_1);
      CHECK(a.weights_2 == b.weights_2);
    }
  }
  CHECK(n_contacts > 100);
  CHECK(n_of_facets > 10);
}
