// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/round_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace contactsim {

namespace {

constexpr std::size_t least_normals = 4;

/// Normals with a greater cosine are one.
constexpr double same_normal = 1.0 - 1e-6;

/// Nodes this near to a plane, over the size of the part, are in it.
constexpr double flat_share = 1e-5;

/// A shape larger than so many times the part is as good as flat: its radius would be chance.
constexpr double largest_shape = 1e3;

/// How a part lies in space. Fits are made about its middle in units of its size.
struct Frame {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double size = 0.0;

  explicit Frame(const SurfacePart& part) {
    for (const Eigen::Vector3d& x : part.nodes) middle += x;
    middle /= static_cast<double>(part.nodes.size());
    for (const Eigen::Vector3d& x : part.nodes) size = std::max(size, (x - middle).norm());
  }
};

SurfacePart scaled(const SurfacePart& part, const Frame& frame) {
  SurfacePart made = part;
  for (Eigen::Vector3d& x : made.nodes) x = (x - frame.middle) / frame.size;
  for (Eigen::Vector3d& x : made.centres) x = (x - frame.middle) / frame.size;
  for (Eigen::Vector3d& area : made.areas) area.normalize();
  return made;
}

std::size_t count_normals(const SurfacePart& part, std::size_t enough) {
  std::vector<Eigen::Vector3d> found;
  for (const Eigen::Vector3d& normal : part.areas) {
    if (std::ranges::none_of(found, [&](const auto& other) { return other.dot(normal) > same_normal; }))
      found.push_back(normal);
    if (found.size() == enough) break;
  }
  return found.size();
}

/// Whether all normals lean by one angle on an axis, as those of cylinders and cones do: two circles, the
/// borders of a band of faces, are always on a sphere.
bool lean_alike(const SurfacePart& part) {
  constexpr double alike = 1e-8;  // the square of what their cosines differ by
  const auto n = static_cast<double>(part.areas.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& normal : part.areas) mean += normal / n;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : part.areas)
    spread += (normal - mean) * (normal - mean).transpose() / n;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues()[0] < alike;
}

bool is_flat(const SurfacePart& part) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& normal : part.areas) mean += normal;
  mean.normalize();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector3d& x : part.nodes) {
    low = std::min(low, mean.dot(x));
    high = std::max(high, mean.dot(x));
  }
  return high - low < flat_share;
}

/// The circle in a plane with the least algebraic residuals; the radius is not needed.
///   points  [2 x n]
std::optional<Eigen::Vector2d> fit_circle(const Eigen::Matrix2Xd& points) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d row(2.0 * points(0, i), 2.0 * points(1, i), 1.0);
    squares += row * row.transpose();
    sums += points.col(i).squaredNorm() * row;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(squares);
  if (!solver.isInvertible()) return std::nullopt;
  return Eigen::Vector2d(solver.solve(sums).head<2>());
}

std::optional<RoundShape> start_sphere(const SurfacePart& part) {
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  for (const Eigen::Vector3d& x : part.nodes) {
    Eigen::Vector4d row;
    row << 2.0 * x, 1.0;
    squares += row * row.transpose();
    sums += x.squaredNorm() * row;
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> solver(squares);
  if (!solver.isInvertible()) return std::nullopt;
  RoundShape shape;
  shape.kind = RoundShape::Kind::spherical;
  shape.origin = solver.solve(sums).head<3>();
  return shape;
}

/// Normals of a cylinder have nothing along its axis.
std::optional<RoundShape> start_cylinder(const SurfacePart& part) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : part.areas) squares += normal * normal.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  RoundShape shape;
  shape.axis = solver.eigenvectors().col(0);
  Eigen::Matrix<double, 2, 3> across = solver.eigenvectors().rightCols<2>().transpose();
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(part.nodes.size()));
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = across * part.nodes[i];
  const auto middle = fit_circle(points);
  if (!middle) return std::nullopt;
  shape.origin = across.transpose() * *middle;
  return shape;
}

/// Normals of a surface of revolution meet its axis: with the moment p x n of a normal at p, and b that of
/// the axis, n . b + (p x n) . a = 0.
std::optional<RoundShape> start_torus(const SurfacePart& part) {
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  for (std::size_t i = 0; i < part.areas.size(); ++i) {
    Eigen::Matrix<double, 6, 1> line;
    line << part.centres[i].cross(part.areas[i]), part.areas[i];
    squares += line * line.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(squares);
  const Eigen::Vector3d a = solver.eigenvectors().col(0).head<3>(),
                        b = solver.eigenvectors().col(0).tail<3>();
  if (!(a.norm() > 1e-6)) return std::nullopt;
  RoundShape shape;
  shape.kind = RoundShape::Kind::toroidal;
  shape.axis = a.normalized();
  const Eigen::Vector3d foot = a.cross(b) / a.squaredNorm();
  Eigen::Matrix2Xd points(2, static_cast<Eigen::Index>(part.nodes.size()));
  for (std::size_t i = 0; i < part.nodes.size(); ++i) {
    const Eigen::Vector3d arm = part.nodes[i] - foot;
    const double height = arm.dot(shape.axis);
    points.col(static_cast<Eigen::Index>(i)) << (arm - height * shape.axis).norm(), height;
  }
  const auto middle = fit_circle(points);
  if (!middle || !((*middle)[0] > 0.0)) return std::nullopt;
  shape.arc_radius = (*middle)[0];
  shape.origin = foot + (*middle)[1] * shape.axis;
  return shape;
}

using Changes = Eigen::Matrix<double, 6, 1>;

/// A shape moved by three lengths, tilted by two angles, its circle wider.
RoundShape changed(const RoundShape& shape, const Changes& by) {
  RoundShape made = shape;
  made.origin += by.head<3>();
  const Eigen::Vector3d across = shape.axis.unitOrthogonal();
  made.axis = (shape.axis + by[3] * across + by[4] * shape.axis.cross(across)).normalized();
  made.arc_radius += by[5];
  return made;
}

/// How far the radii of nodes are from their mean.
Eigen::VectorXd residuals_of(const RoundShape& shape, const SurfacePart& part, double& radius) {
  Eigen::VectorXd radii(static_cast<Eigen::Index>(part.nodes.size()));
  for (std::size_t i = 0; i < part.nodes.size(); ++i)
    radii[static_cast<Eigen::Index>(i)] = shape.radius_of(part.nodes[i]);
  radius = radii.mean();
  return radii.array() - radius;
}

/// Gauss and Newton's method, the derivatives by differences.
void refine(const SurfacePart& part, RoundShape& shape) {
  constexpr int max_iterations = 20;
  constexpr double difference = 1e-6, accuracy = 1e-12, slack = 1e-10;
  const Eigen::Index n_changes = shape.kind == RoundShape::Kind::spherical         ? 3
                                 : shape.kind == RoundShape::Kind::circumferential ? 5
                                                                                   : 6;
  double radius = 0.0;
  for (int i = 0; i < max_iterations; ++i) {
    const Eigen::VectorXd now = residuals_of(shape, part, radius);
    Eigen::MatrixXd slopes(now.size(), n_changes);
    for (Eigen::Index k = 0; k < n_changes; ++k) {
      const Changes step = difference * Changes::Unit(k);
      slopes.col(k) = (residuals_of(changed(shape, step), part, radius) -
                       residuals_of(changed(shape, -step), part, radius)) /
                      (2.0 * difference);
    }
    Eigen::MatrixXd squares = slopes.transpose() * slopes;
    squares.diagonal().array() += slack * squares.trace();  // what nothing depends on stays
    Changes change = Changes::Zero();
    change.head(n_changes) = -squares.ldlt().solve(slopes.transpose() * now);
    if (!change.allFinite()) return;
    shape = changed(shape, change);
    if (change.norm() < accuracy) return;
  }
}

}  // namespace

PartFit fit_part(const SurfacePart& part) {
  PartFit fit;
  fit.least_residual = std::numeric_limits<double>::infinity();
  const Frame frame(part);
  if (!(frame.size > 0.0)) return fit;
  const SurfacePart own = scaled(part, frame);
  fit.is_flat = is_flat(own);
  if (fit.is_flat || count_normals(own, least_normals) < least_normals) return fit;
  const bool is_bent_once = lean_alike(own);
  for (const auto start : {start_cylinder, start_sphere, start_torus}) {
    auto shape = start(own);
    if (!shape || (is_bent_once && shape->kind != RoundShape::Kind::circumferential)) continue;
    refine(own, *shape);
    double radius = 0.0;
    const double residual = residuals_of(*shape, own, radius).lpNorm<Eigen::Infinity>();
    if (!(radius < largest_shape) || !(shape->arc_radius < largest_shape)) continue;
    fit.least_residual = std::min(fit.least_residual, residual / radius);
    if (!(residual <= largest_residual * radius)) continue;
    shape->origin = frame.middle + frame.size * shape->origin;
    shape->arc_radius *= frame.size;
    fit.shape = FittedShape{*shape, frame.size * radius, frame.size * residual, 0};
    return fit;
  }
  return fit;
}

}  // namespace contactsim
