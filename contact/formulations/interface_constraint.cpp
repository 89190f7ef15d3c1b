// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/interface_constraint.hpp"

#include <Eigen/LU>

namespace contactsim {

namespace {

/// The moment about the origin of forces at points.
Eigen::Vector3d moment(const CornerVectors& x, const CornerVectors& forces) {
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

}  // namespace

Eigen::Matrix3d axes_of(const FaceCorners& x) {
  Eigen::Matrix3d axes;
  const Eigen::Vector3d normal = area_vector(x).normalized(), diagonal = x.col(2) - x.col(0);
  axes.col(0) = (diagonal - normal.dot(diagonal) * normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

void balance(const CornerVectors& arms, CornerVectors& forces) {
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

const PairRule& rule_of(const ContactStepContext& context, const InterfaceConstraint& constraint) {
  return constraint.is_node
             ? context.rules.of_node(constraint.pair, constraint.row())
             : context.rules.of_faces(constraint.pair, constraint.first_face(), constraint.second);
}

CornerVectors corners_of(const ContactStepContext& context, const InterfaceConstraint& constraint) {
  CornerVectors x;
  for (std::size_t k = 0; k < 8; ++k)
    x.col(static_cast<Eigen::Index>(k)) = context.kinematics.x(constraint.nodes[k]);
  return x;
}

bool keep_constraint(const ContactRemap& remap, InterfaceConstraint& constraint) {
  const auto first = constraint.is_node ? number_after(remap.rows, constraint.first_entity)
                                        : number_after(remap.faces, constraint.first_entity);
  const OptionalIndex<FaceIndex> second = remap.faces[constraint.second];
  if (!first || !second) return false;
  constraint.first_entity = *first;
  constraint.second = *second;
  for (ContactNodeIndex& node : constraint.nodes) node = *remap.nodes[node];
  return true;
}

void visit_constraint(InterfaceConstraint& constraint, RowNumbers& row) {
  row(constraint.pair.value, constraint.is_swapped, constraint.first_entity, constraint.second.value,
      constraint.is_node, constraint.nodes, constraint.springs, constraint.area, constraint.share);
}

}  // namespace contactsim
