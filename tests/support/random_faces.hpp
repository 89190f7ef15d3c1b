// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <vector>

#include "contact/geometry/face_face.hpp"

/// Faces that are skewed, warped and moved about, the same for the same random numbers.
namespace contactsim::test {

using Random = std::mt19937;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Eigen::Vector3d random_vector(Random& random, double size) {
  return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

inline Eigen::Matrix3d random_rotation(Random& random) {
  const Eigen::Vector3d axis = random_vector(random, 1.0).normalized();
  return Eigen::AngleAxisd(uniform(random, 0.0, 3.0), axis).toRotationMatrix();
}

/// A face through its corners; a triangle repeats its last.
inline MovingFace make_face(const FaceCorners& x, const FaceCorners& v = FaceCorners::Zero()) {
  return {x, v, x.col(2) == x.col(3)};
}

/// A square from (left, 0, z) of a width that looks up, or down.
inline MovingFace make_square(double left, double z, bool looks_up, double width = 1.0) {
  FaceCorners x;
  x.col(0) << left, 0.0, z;
  x.col(1) << left + width, 0.0, z;
  x.col(2) << left + width, width, z;
  x.col(3) << left, width, z;
  if (!looks_up) x.col(1).swap(x.col(3));
  return make_face(x);
}

/// A face of size about 1 around (0, 0, z), every corner moved at random by up to a tenth.
inline MovingFace random_face(Random& random, bool is_triangle, bool looks_up, double z) {
  MovingFace face = make_square(-0.5, z, looks_up);
  face.x.row(1).array() -= 0.5;
  if (is_triangle) face.x.col(3) = face.x.col(2);
  const double turn = uniform(random, 0.0, 1.5);
  face.x = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix() * face.x;
  face.x.colwise() += Eigen::Vector3d(uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3), 0.0);
  for (int k = 0; k < 4; ++k) {
    face.x.col(k) += random_vector(random, 0.1);
    face.v.col(k) = random_vector(random, 1.0);
  }
  if (is_triangle) {
    face.x.col(3) = face.x.col(2);
    face.v.col(3) = face.v.col(2);
  }
  return make_face(face.x, face.v);
}

inline MovingFace turned(const MovingFace& face, const Eigen::Matrix3d& rotation,
                         const Eigen::Vector3d& shift) {
  MovingFace turned = make_face((rotation * face.x).colwise() + shift, rotation * face.v);
  turned.sharpness = face.sharpness;
  return turned;
}

/// The same face, its corners counted from the next one.
inline MovingFace renumbered(const MovingFace& face) {
  const int n = face.is_triangle ? 3 : 4;
  FaceCorners x, v;
  for (int k = 0; k < 4; ++k) {
    x.col(k) = face.x.col((std::min(k, n - 1) + 1) % n);
    v.col(k) = face.v.col((std::min(k, n - 1) + 1) % n);
  }
  return make_face(x, v);
}

/// The faces of eight pairs that may overlap, triangles and quadrilaterals in turns.
struct FacesOfPairs {
  std::vector<MovingFace> first, second;
};

///   turn    which of them are triangles
///   lowest, highest  between which heights the second ones stand over the first [length]
inline FacesOfPairs random_pairs(Random& random, int turn, double lowest, double highest) {
  FacesOfPairs faces;
  for (int k = 0; k < n_lanes; ++k) {
    faces.first.push_back(random_face(random, (turn + k) % 3 == 0, true, 0.0));
    faces.second.push_back(random_face(random, (turn + k) % 4 == 0, false, uniform(random, lowest, highest)));
  }
  return faces;
}

}  // namespace contactsim::test
