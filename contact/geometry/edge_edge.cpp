// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/edge_edge.hpp"

#include <algorithm>

namespace contactsim {

namespace {

/// Square of the sine of the angle below which segments count as parallel.
constexpr double parallel = 0.01;

/// Within this of a node a point is at the node: round-off must not have it inside both edges that meet
/// there.
constexpr double at_node = 1e-9;

double at_node_or_inside(double share) {
  if (share < at_node) return 0.0;
  return share > 1.0 - at_node ? 1.0 : share;
}

/// Place of a point along a segment, within it.
double along(const Segment& segment, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = segment.col(1) - segment.col(0);
  const double square = way.squaredNorm();
  return square > 0.0 ? std::clamp(way.dot(point - segment.col(0)) / square, 0.0, 1.0) : 0.0;
}

Eigen::Vector3d at(const Segment& segment, double share) {
  return segment.col(0) + share * (segment.col(1) - segment.col(0));
}

}  // namespace

EdgePairPoint nearest_points(const Segment& first, const Segment& second) {
  const Eigen::Vector3d p = first.col(1) - first.col(0), q = second.col(1) - second.col(0);
  const double pp = p.squaredNorm(), qq = q.squaredNorm(), pq = p.dot(q), det = pp * qq - pq * pq;
  const Eigen::Vector3d r = first.col(0) - second.col(0);
  EdgePairPoint pair_point;
  if (pp == 0.0 || qq == 0.0 || !(det > 0.0)) {
    pair_point.s = pp == 0.0 ? 0.0 : along(first, second.col(0));
    pair_point.t = along(second, at(first, pair_point.s));
  } else {
    pair_point.s = std::clamp((pq * q.dot(r) - qq * p.dot(r)) / det, 0.0, 1.0);
    pair_point.t = (pq * pair_point.s + q.dot(r)) / qq;
  }
  if (pair_point.t < 0.0 || pair_point.t > 1.0) pair_point.t = std::clamp(pair_point.t, 0.0, 1.0);
  if (pp > 0.0) pair_point.s = along(first, at(second, pair_point.t));
  pair_point.s = at_node_or_inside(pair_point.s);
  pair_point.t = at_node_or_inside(pair_point.t);
  return pair_point;
}

EdgePairPoints::EdgePairPoints(const Segment& first, const Segment& second) {
  const Eigen::Vector3d p = first.col(1) - first.col(0), q = second.col(1) - second.col(0);
  const double square = p.squaredNorm() * q.squaredNorm();
  const double cosine = p.dot(q);
  const bool is_parallel = square > 0.0 && square - cosine * cosine < parallel * square;
  if (is_parallel && add_parallel(first, second)) return;
  points_[0] = nearest_points(first, second);
  points_[0].is_parallel = is_parallel;
  n_ = 1;
}

bool EdgePairPoints::add_parallel(const Segment& first, const Segment& second) {
  const Eigen::Vector3d p = first.col(1) - first.col(0);
  const double square = p.squaredNorm();
  const auto on_line = [&](Eigen::Index end) { return p.dot(second.col(end) - first.col(0)) / square; };
  const double from = std::max(0.0, std::min(on_line(0), on_line(1)));
  const double to = std::min(1.0, std::max(on_line(0), on_line(1)));
  if (!(to > from)) return false;
  const double half = 0.5 * (to - from) * p.norm();
  points_[0] = {from, along(second, at(first, from)), half, true};
  points_[1] = {to, along(second, at(first, to)), half, true};
  n_ = 2;
  return true;
}

}  // namespace contactsim
