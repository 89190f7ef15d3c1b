// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/ties.hpp"

#include <Eigen/LU>

namespace contactsim {

namespace {

using Corners8 = Eigen::Matrix<double, 8, 1>;

/// Adds a spring between a point of the first side and one of the second.
///   weights  of the corners: those of the first side, minus those of the second
///   offset   between the points, in axes of the second face [length]
void add_spring(const Corners8& weights, double stiffness, const Eigen::Vector3d& offset, Tie& tie) {
  tie.stiffness += stiffness * weights * weights.transpose();
  tie.springs += stiffness * weights.cwiseAbs();
  tie.rest += stiffness * offset * weights.transpose();
  tie.rest_energy += 0.5 * stiffness * offset.squaredNorm();
}

Corners8 join(const Eigen::Vector4d& first, const Eigen::Vector4d& second) {
  Corners8 weights;
  weights << first, -second;
  return weights;
}

/// The moment about the origin of forces at points.
Eigen::Vector3d moment(const TieVectors& x, const TieVectors& forces) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 8; ++k) sum += x.col(k).cross(forces.col(k));
  return sum;
}

/// The corners of a face as equal masses.
struct CornerMasses {
  int n = 4;
  Eigen::Vector3d mean;
  Eigen::Matrix3d inverse_inertia;  ///< about the mean [1/length^2]
};

CornerMasses corner_masses(const FaceCorners& x) {
  CornerMasses masses;
  if (x.col(2) == x.col(3)) masses.n = 3;
  masses.mean = x.leftCols(masses.n).rowwise().mean();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (int k = 0; k < masses.n; ++k) {
    const Eigen::Vector3d arm = x.col(k) - masses.mean;
    inertia += arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
  }
  masses.inverse_inertia = inertia.inverse();
  return masses;
}

/// Forces at the second side's corners that have a moment but no resultant, the smallest that do.
Eigen::Matrix<double, 3, 4> couple(const Eigen::Matrix<double, 3, 4>& x, const Eigen::Vector3d& moment) {
  const CornerMasses masses = corner_masses(x);
  const Eigen::Vector3d turn = masses.inverse_inertia * moment;
  Eigen::Matrix<double, 3, 4> forces = Eigen::Matrix<double, 3, 4>::Zero();
  for (int k = 0; k < masses.n; ++k) forces.col(k) = turn.cross(x.col(k) - masses.mean);
  return forces;
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return matrix;
}

/// Makes means of sums by area; points without area go.
void finish_points(Tie& tie) {
  constexpr double negligible = 1e-6;  // of the area
  tie.n_points = 0;
  for (const TiePoint& sum : std::array(tie.points)) {
    if (!(sum.area > negligible * tie.area)) continue;
    TiePoint& point = tie.points[tie.n_points++] = sum;
    point.weights_1 /= sum.area;
    point.weights_2 /= sum.area;
    point.offset /= sum.area;
  }
}

}  // namespace

Eigen::Matrix3d axes_of(const FaceCorners& x) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d normal = area_vector(x).normalized(), diagonal = x.col(2) - x.col(0);
  axes.col(0) = (diagonal - normal.dot(diagonal) * normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

void balance(const TieVectors& arms, TieVectors& forces) {
  forces.col(7) -= forces.rowwise().sum();
  forces.rightCols<4>() -= couple(arms.rightCols<4>(), moment(arms, forces));
}

std::array<Eigen::Matrix3d, 4> carry_point(const FaceCorners& x, const Eigen::Vector4d& weights,
                                           const Eigen::Vector3d& offset) {
  std::array<Eigen::Matrix3d, 4> transferred;
  for (int k = 0; k < 4; ++k)
    transferred[static_cast<std::size_t>(k)] = weights[k] * Eigen::Matrix3d::Identity();
  if (offset.isZero(0.0)) return transferred;
  // The face turns by inverse_inertia * sum of arm x velocity, and moves the point by turn x offset.
  const CornerMasses masses = corner_masses(x);
  const Eigen::Matrix3d of_turn = -cross_matrix(offset) * masses.inverse_inertia;
  for (int k = 0; k < masses.n; ++k)
    transferred[static_cast<std::size_t>(k)] += of_turn * cross_matrix(x.col(k) - masses.mean);
  return transferred;
}

bool tie_faces(const MovingFace& first, const MovingFace& second, double stiffness, double tolerance,
               Tie& tie) {
  const auto found = find_face_face_points(first, second);
  if (!found) return false;
  const Eigen::Matrix3d axes = axes_of(second.x);
  const Eigen::Vector3d along = axes.transpose() * found->plane.normal;
  found->visit_near(tolerance, [&](double area, double gap, const Eigen::Vector4d& weights_1,
                                   const Eigen::Vector4d& weights_2) {
    add_spring(join(weights_1, weights_2), stiffness * area, gap * along, tie);
    tie.area += area;
    for (int k = 0; k < 4; ++k) {
      if (weights_2[k] == 0.0) continue;
      TiePoint& point = tie.points[static_cast<std::size_t>(k)];
      const double share = area * weights_2[k];
      point.area += share;
      point.weights_1 += share * weights_1;
      point.weights_2 += share * weights_2;
      point.offset += share * gap * along;
    }
  });
  finish_points(tie);
  return tie.area > 0.0;
}

void tie_node(const Eigen::Vector3d& node, const MovingFace& face, const Eigen::Vector4d& weights,
              double stiffness, Tie& tie) {
  const Eigen::Vector3d offset = axes_of(face.x).transpose() * (node - face.x * weights);
  add_spring(join(Eigen::Vector4d::UnitX(), weights), stiffness, offset, tie);
  tie.n_points = 1;
  tie.points[0] = {tie.area, Eigen::Vector4d::UnitX(), weights, offset, Eigen::Vector3d::Zero()};
}

TieForces find_tie_forces(const Tie& tie, const TieVectors& x) {
  const FaceCorners second = x.rightCols<4>();
  const Eigen::Matrix3d axes = axes_of(second);
  TieForces found;
  const Eigen::Vector3d origin = x.col(0);  // large coordinates would cost digits
  const TieVectors arms = x.colwise() - origin;
  const TieVectors rest = axes * tie.rest, pull = arms * tie.stiffness;
  found.forces = rest - pull;
  found.stored = (0.5 * pull - rest).cwiseProduct(arms).sum() + tie.rest_energy;
  // Products of a large stiffness cancel to small forces with an error, which must not push the whole.
  balance(arms, found.forces);
  found.normal = axes.col(2);
  return found;
}

}  // namespace contactsim
