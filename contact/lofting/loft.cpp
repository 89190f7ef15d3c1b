// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/lofting/loft_joints.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// Grows the arrays of a LoftGeometry.
class LoftBuilder {
 public:
  LoftBuilder(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates, std::span<const ElementIndex> elements)
      : mesh_(mesh), coordinates_(coordinates) {
    for (const ElementIndex element : elements) {
      const Family family = family_of(element);
      if (family == Family::shell) shells_.push_back(element);
      if (family == Family::line) lines_.push_back(element);
    }
    count_line_ends();
    neighbours_.emplace(mesh, coordinates, shells_);
  }

  void add(ElementIndex element, const LoftSize& size) {
    switch (family_of(element)) {
      case Family::shell:
        return add_brick(element, size);
      case Family::line:
        return add_prism(element, size);
      case Family::particle:
        loft_.spheres.push_back({element, mesh_.element_nodes(element)[0], size.radius});
        return;
      case Family::solid:
      case Family::cohesive:
      case Family::none:
        return;
    }
  }

  LoftGeometry take() {
    loft_.vertices.resize(3, static_cast<Eigen::Index>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i)
      loft_.vertices.col(static_cast<Eigen::Index>(i)) = points_[i];
    loft_.shells = std::move(shells_);
    return std::move(loft_);
  }

 private:
  Family family_of(ElementIndex element) const {
    return topology(mesh_.blocks()[mesh_.block_of(element)].shape).family;
  }

  std::uint32_t add_vertex(NodeIndex node, const Eigen::Vector3d& way, const LoftOffset& offset = {}) {
    points_.emplace_back(coordinates_.col(node.value) + way);
    loft_.node_of_vertex.push_back(node);
    loft_.offsets.push_back(offset);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  void count_line_ends() {
    for (const ElementIndex line : lines_) {
      for (const NodeIndex end : mesh_.element_nodes(line).first(2)) line_ends_.push_back(end);
    }
    std::sort(line_ends_.begin(), line_ends_.end());
  }

  bool is_free_end(NodeIndex node) const {
    const auto [first, last] = std::equal_range(line_ends_.begin(), line_ends_.end(), node);
    return last - first == 1;
  }

  void add_brick(ElementIndex element, const LoftSize& size);
  void add_prism(ElementIndex element, const LoftSize& size);

  const Mesh& mesh_;
  const Eigen::Matrix3Xd& coordinates_;
  std::vector<ElementIndex> shells_, lines_;
  std::vector<NodeIndex> line_ends_;  ///< sorted, a node as often as lines end in it
  std::optional<ShellNeighbours> neighbours_;
  std::vector<Eigen::Vector3d> points_;
  LoftGeometry loft_;
};

void LoftBuilder::add_brick(ElementIndex element, const LoftSize& size) {
  const auto shell =
      static_cast<std::uint32_t>(std::lower_bound(shells_.begin(), shells_.end(), element) - shells_.begin());
  const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(element)].shape);
  const auto nodes = mesh_.element_nodes(element).first(shape.n_corners);
  const std::size_t n = nodes.size();
  std::array<std::uint32_t, 4> top{}, bottom{};
  for (std::size_t i = 0; i < n; ++i) {
    const auto around = neighbours_->around(shell, static_cast<int>(i));
    const Eigen::Vector3d normal = neighbours_->mean_normal(around);
    LoftOffset offset{static_cast<std::uint32_t>(loft_.offset_shells.size()),
                      static_cast<std::uint32_t>(around.size()), size.thickness * size.lofting_factor,
                      size.thickness};
    loft_.offset_shells.insert(loft_.offset_shells.end(), around.begin(), around.end());
    top[i] = add_vertex(nodes[i], normal * offset.height, offset);
    offset.height = -size.thickness * (1.0 - size.lofting_factor);
    bottom[i] = add_vertex(nodes[i], normal * offset.height, offset);
  }
  loft_.facets.push_back({element, LoftPart::top, 1, {top[0], top[1], top[2], top[n - 1]}});
  loft_.facets.push_back(
      {element, LoftPart::bottom, 2, {bottom[0], bottom[n - 1], bottom[n - 2], bottom[1]}});
  for (std::size_t i = 0; i < n; ++i) {
    if (!neighbours_->is_perimeter(shell, static_cast<int>(i))) continue;
    const std::size_t j = (i + 1) % n;
    loft_.facets.push_back(
        {element, LoftPart::side, static_cast<std::uint8_t>(i + 3), {bottom[i], bottom[j], top[j], top[i]}});
  }
}

/// A unit vector across the axis, the same for the same axis on every machine.
Eigen::Vector3d across(const Eigen::Vector3d& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Eigen::Vector3d(Eigen::Vector3d::Unit(least))).normalized();
}

void LoftBuilder::add_prism(ElementIndex element, const LoftSize& size) {
  constexpr std::size_t n = 6;
  loft_.capsules.push_back({element, size.radius});
  const auto ends = mesh_.element_nodes(element).first(2);
  const Eigen::Vector3d axis =
      (coordinates_.col(ends[1].value) - coordinates_.col(ends[0].value)).normalized();
  const Eigen::Vector3d u = across(axis), v = axis.cross(u);
  std::array<std::array<std::uint32_t, n>, 2> ring{};
  for (std::size_t end = 0; end < 2; ++end) {
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = static_cast<double>(i) * std::numbers::pi / 3.0;
      ring[end][i] = add_vertex(ends[end], size.radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  const auto add_facet = [&](std::array<std::uint32_t, 4> corners) {
    loft_.facets.push_back({element, LoftPart::prism, 1, corners});
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    add_facet({ring[0][i], ring[0][j], ring[1][j], ring[1][i]});
  }
  const auto& back = ring[0];
  const auto& front = ring[1];
  if (is_free_end(ends[0])) {
    add_facet({back[3], back[2], back[1], back[0]});
    add_facet({back[0], back[5], back[4], back[3]});
  }
  if (is_free_end(ends[1])) {
    add_facet({front[0], front[1], front[2], front[3]});
    add_facet({front[3], front[4], front[5], front[0]});
  }
}

}  // namespace

LoftGeometry make_loft(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates,
                       std::span<const ElementIndex> elements, std::span<const LoftSize> sizes) {
  LoftBuilder builder(mesh, coordinates, elements);
  for (std::size_t i = 0; i < elements.size(); ++i) builder.add(elements[i], sizes[i]);
  LoftGeometry loft = builder.take();
  add_joints(mesh, coordinates, loft);
  return loft;
}

double facet_area(const LoftGeometry& loft, const LoftFacet& facet) {
  const auto x = [&](std::size_t corner) -> Eigen::Vector3d {
    return loft.vertices.col(facet.vertices[corner]);
  };
  return area_vector(x(0), x(1), x(2), x(3)).norm();
}

}  // namespace contactsim
