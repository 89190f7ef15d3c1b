// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/element_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/errors.hpp"

namespace contactsim {

namespace {

constexpr std::size_t n_shown = 5;

// Smaller blocks are done before a second thread is awake.
constexpr std::int64_t fewest_parallel = 2000;

struct FlatElement {
  ElementIndex element;
  double volume = 0.0;
};

double triple(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.cross(b).dot(c);
}

// Six times the volume between the origin and a face; a bilinear face halves the tetrahedron of its corners,
// so it is the mean of the two ways to cut it into triangles.
double cone_volume(const Side& side, const std::array<Eigen::Vector3d, 8>& x) {
  const Eigen::Vector3d &a = x[side.corners[0]], &b = x[side.corners[1]], &c = x[side.corners[2]];
  if (side.n_corners == 3) return triple(a, b, c);
  const Eigen::Vector3d& d = x[side.corners[3]];
  return 0.5 * (triple(a, b, c) + triple(a, c, d) + triple(a, b, d) + triple(b, c, d));
}

// Volumes below this are round-off: coordinates of size `far` carry errors of eps * far each.
double round_off(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes,
                 const Topology& shape) {
  double far = 0.0, extent = 0.0;
  const Eigen::Vector3d origin = coordinates.col(nodes[0].value);
  for (std::size_t i = 0; i < shape.n_corners; ++i) {
    const Eigen::Vector3d x = coordinates.col(nodes[i].value);
    far = std::max(far, x.lpNorm<Eigen::Infinity>());
    extent = std::max(extent, (x - origin).lpNorm<Eigen::Infinity>());
  }
  return 8.0 * std::numeric_limits<double>::epsilon() * far * extent * extent;
}

// Elements of a block without positive volume, in order.
std::vector<FlatElement> find_flat(const Mesh& mesh, const ElementBlock& block) {
  const Topology& shape = topology(block.shape);
  std::vector<FlatElement> found;
  const auto n = static_cast<std::int64_t>(block.n_elements);
#pragma omp parallel for schedule(static) if (n >= fewest_parallel)
  for (std::int64_t e = 0; e < n; ++e) {
    const auto nodes = block.element_nodes(static_cast<std::uint32_t>(e));
    const double volume = solid_volume(mesh.coordinates(), nodes, shape);
    if (volume > round_off(mesh.coordinates(), nodes, shape)) continue;
#pragma omp critical(contactsim_flat_elements)
    found.push_back({{block.first_element.value + static_cast<std::uint32_t>(e)}, volume});
  }
  std::sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.element < b.element; });
  return found;
}

void check_type(const Mesh& mesh, std::uint32_t index) {
  const ElementBlock& block = mesh.blocks()[index];
  if (block.shape != Shape::unknown) return;
  const std::string what =
      block.type_name.empty()
          ? "the file does not say what type of elements it has"
          : fmt::format("its elements are of type '{}' with {} nodes, which contactsim does not know",
                        block.type_name, block.nodes_per_element);
  throw FileError(mesh.path(), mesh.name({EntityKind::block, index}) + ": " + what);
}

}  // namespace

double solid_volume(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes,
                    const Topology& shape) {
  // About the first corner, so that an element far from the origin keeps its digits.
  const Eigen::Vector3d origin = coordinates.col(nodes[0].value);
  std::array<Eigen::Vector3d, 8> x;
  for (std::size_t i = 0; i < shape.n_corners; ++i) x[i] = coordinates.col(nodes[i].value) - origin;
  double sum = 0.0;
  for (const Side& side : shape.sides) sum += cone_volume(side, x);
  return sum / 6.0;
}

void check_elements(const Mesh& mesh, std::span<const std::uint32_t> blocks) {
  std::size_t n_flat = 0;
  std::string shown;
  for (std::uint32_t index : blocks) {
    check_type(mesh, index);
    const ElementBlock& block = mesh.blocks()[index];
    if (topology(block.shape).family != Family::solid) continue;
    for (const FlatElement& flat : find_flat(mesh, block)) {
      if (++n_flat > n_shown) continue;
      shown += fmt::format("\n  {}: element {}: volume {:g}", mesh.name({EntityKind::block, index}),
                           mesh.element_id(flat.element), flat.volume);
    }
  }
  if (n_flat == 0) return;
  if (n_flat > n_shown) shown += fmt::format("\n  and {} more", n_flat - n_shown);
  throw FileError(mesh.path(), fmt::format("{} element{} inside out or without volume:{}", n_flat,
                                           n_flat == 1 ? " is" : "s are", shown));
}

}  // namespace contactsim
