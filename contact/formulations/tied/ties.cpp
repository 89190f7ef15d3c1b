// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/ties.hpp"

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

/// The stiffness per area of the springs of a tie: their weights of a side sum up to 1 [force/length^3].
double stiffness_of(const Tie& tie) { return tie.stiffness.topLeftCorner<4, 4>().sum() / tie.area; }

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

Eigen::Vector3d offset_of(const TiePoint& point, const CornerVectors& x) {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  for (int k = 0; k < 4; ++k)
    offset += point.weights_1[k] * (x.col(k) - x.col(0)) - point.weights_2[k] * (x.col(k + 4) - x.col(0));
  return offset;
}

CornerForces find_tie_forces(const Tie& tie, const CornerVectors& x) {
  const FaceCorners second = x.rightCols<4>();
  const Eigen::Matrix3d axes = axes_of(second);
  CornerForces found;
  const Eigen::Vector3d origin = x.col(0);  // large coordinates would cost digits
  const CornerVectors arms = x.colwise() - origin;
  const CornerVectors rest = axes * tie.rest, pull = arms * tie.stiffness;
  found.forces = rest - pull;
  found.stored = (0.5 * pull - rest).cwiseProduct(arms).sum() + tie.rest_energy;
  // Products of a large stiffness cancel to small forces with an error, which must not push the whole.
  balance(arms, found.forces);
  found.normal = axes.col(2);
  return found;
}

CornerForces find_point_forces(const Tie& tie, const CornerVectors& x) {
  const FaceCorners second = x.rightCols<4>();
  const Eigen::Matrix3d axes = axes_of(second);
  CornerForces found{CornerVectors::Zero(), axes.col(2)};
  for (std::uint32_t p = 0; p < tie.n_points; ++p) {
    const TiePoint& point = tie.points[p];
    const Eigen::Vector3d force = axes * point.force;
    found.forces.leftCols<4>() += force * point.weights_1.transpose();
    const auto transferred = carry_point(second, point.weights_2, offset_of(point, x));
    for (std::size_t k = 0; k < 4; ++k)
      found.forces.col(static_cast<Eigen::Index>(k) + 4) -= transferred[k].transpose() * force;
  }
  return found;
}

/// Springs of stiffness k a with weights w and ends d apart hold a gap o open by k a (d - o). Others of c
/// times their stiffness do so over the gap d - (d - o) / c, with 1 / c of the energy.
void renew_springs(double stiffness, const CornerVectors& x, Tie& tie) {
  const double factor = stiffness / stiffness_of(tie);
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  const double stored = find_tie_forces(tie, x).stored;
  const CornerVectors arms = x.colwise() - x.col(0);
  tie.rest += (factor - 1.0) * axes.transpose() * arms * tie.stiffness;
  tie.stiffness *= factor;
  tie.springs *= factor;
  tie.rest_energy += stored / factor - find_tie_forces(tie, x).stored;
}

void replace_springs_by_points(const CornerVectors& x, Tie& tie) {
  const double stiffness = stiffness_of(tie);
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  const CornerVectors of_springs = find_tie_forces(tie, x).forces;
  for (std::uint32_t p = 0; p < tie.n_points; ++p) {
    TiePoint& point = tie.points[p];
    const Eigen::Vector3d now = axes.transpose() * offset_of(point, x);
    point.force = stiffness * point.area * (point.offset - now);
    point.offset = now;
  }
  tie.stiffness.setZero();
  tie.springs.setZero();
  tie.rest = axes.transpose() * (of_springs - find_point_forces(tie, x).forces);
  tie.rest_energy = 0.0;
  tie.rest_energy = -find_tie_forces(tie, x).stored;
}

}  // namespace contactsim
