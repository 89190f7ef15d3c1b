// SPDX-License-Identifier: BSD-3-Clause
#include "search_scene.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim::bench {

namespace {

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }

void add_point(const Eigen::Vector3d& point, Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = as_float(point[static_cast<Eigen::Index>(axis)]);
    box.lo[axis] = std::min(box.lo[axis], x);
    box.hi[axis] = std::max(box.hi[axis], x);
  }
}

Box box_around(const Eigen::Vector3d& point) {
  const std::array<double, 3> at{as_float(point[0]), as_float(point[1]), as_float(point[2])};
  return {at, at};
}

std::vector<Box> node_boxes(const QuadSurface& surface) {
  std::vector<Box> boxes;
  for (const auto& point : surface.positions.colwise()) {
    boxes.push_back(box_around(point - Eigen::Vector3d::Constant(0.2)));
    add_point(point + Eigen::Vector3d::Constant(0.2), boxes.back());
  }
  return boxes;
}

std::vector<Box> face_boxes(const QuadSurface& surface) {
  std::vector<Box> boxes;
  for (const auto& quad : surface.quads) {
    boxes.push_back(box_around(surface.positions.col(quad[0])));
    for (const std::uint32_t node : quad) add_point(surface.positions.col(node), boxes.back());
  }
  return boxes;
}

}  // namespace

SearchScene::SearchScene(std::int64_t n_faces)
    : pair_(make_sphere_pair(
          static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n_faces) / 6.0))))),
      nodes_(node_boxes(pair_.inner)) {
  move();
}

void SearchScene::move() {
  constexpr double turn_per_search = 1e-3;
  turn(pair_.outer, turn_per_search);
  faces_ = face_boxes(pair_.outer);
}

}  // namespace contactsim::bench
