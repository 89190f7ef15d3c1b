// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/element_checks.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/errors.hpp"
#include "core/base/threads.hpp"

namespace contactsim {

namespace {

constexpr std::size_t n_shown = 5;
constexpr std::size_t max_shape_nodes = 10;  // see Topology::n_shape_nodes

enum class Doubt : std::uint8_t { inverted, flat, boundless };

struct DoubtfulElement {
  ElementIndex element;
  double size = 0.0;  // volume, or area [length^3] [length^2]
  Doubt doubt = Doubt::flat;
};

/// Counts elements and describes the first few.
class ElementList {
 public:
  ///   size  "volume 0"
  void add(const std::string& block, std::int64_t element_id, const std::string& size) {
    if (++count_ <= n_shown) text_ += fmt::format("\n  {}: element {}: {}", block, element_id, size);
  }
  std::size_t count() const { return count_; }
  std::string describe(std::string_view what) const {
    const std::string rest = count_ > n_shown ? fmt::format("\n  and {} more", count_ - n_shown) : "";
    return fmt::format("{} element{} {}:{}{}", count_, count_ == 1 ? " is" : "s are", what, text_, rest);
  }

 private:
  std::size_t count_ = 0;
  std::string text_;
};

double triple(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  return a.cross(b).dot(c);
}

// Six times the volume between the origin and a face; a bilinear face halves the tetrahedron of its corners,
// so it is the mean of the two ways to cut it into triangles.
double cone_volume(const FacetCorners& corners, const std::array<Eigen::Vector3d, max_shape_nodes>& x) {
  const Eigen::Vector3d &a = x[corners[0]], &b = x[corners[1]], &c = x[corners[2]];
  if (corners[2] == corners[3]) return triple(a, b, c);
  const Eigen::Vector3d& d = x[corners[3]];
  return 0.5 * (triple(a, b, c) + triple(a, c, d) + triple(a, b, d) + triple(b, c, d));
}

double shell_area(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes,
                  const Topology& shape) {
  const auto side = [&](std::size_t from, std::size_t to) -> Eigen::Vector3d {
    return coordinates.col(nodes[to].value) - coordinates.col(nodes[from].value);
  };
  const bool is_triangle = shape.n_corners == 3;
  return 0.5 * side(0, is_triangle ? 1 : 2).cross(side(is_triangle ? 0 : 1, is_triangle ? 2 : 3)).norm();
}

/// Whether a solid of corners alone has so much volume that no rounding makes it doubtful. The four terms of
/// a face are (b x c) (a + d) + (d x a) (b + c): half the products of cone_volume(), and rounded otherwise.
bool is_plainly_sound(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes,
                      const Topology& shape, double noise) {
  constexpr double rounding = 1e-10;
  if (shape.n_shape_nodes() != shape.n_corners) return false;
  const Eigen::Vector3d origin = coordinates.col(nodes[0].value);
  std::array<Eigen::Vector3d, max_shape_nodes> x;
  double extent = 0.0;
  for (std::size_t i = 0; i < shape.n_corners; ++i) {
    x[i] = coordinates.col(nodes[i].value) - origin;
    extent = std::max(extent, x[i].lpNorm<Eigen::Infinity>());
  }
  double sum = 0.0;
  for (const Side& side : shape.sides) {
    const Eigen::Vector3d &a = x[side.corners[0]], &b = x[side.corners[1]], &c = x[side.corners[2]];
    if (side.corners[2] == side.corners[3]) {
      sum += triple(a, b, c);
    } else {
      const Eigen::Vector3d& d = x[side.corners[3]];
      sum += 0.5 * (b.cross(c).dot(a + d) + d.cross(a).dot(b + c));
    }
  }
  return std::isfinite(sum) && sum > 6.0 * noise + rounding * extent * extent * extent;
}

// Sizes below this are round-off: coordinates of size `far` carry errors of eps * far each.
double round_off(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes,
                 const Topology& shape) {
  double far = 0.0, extent = 0.0;
  const Eigen::Vector3d origin = coordinates.col(nodes[0].value);
  for (std::size_t i = 0; i < shape.n_corners; ++i) {
    const Eigen::Vector3d x = coordinates.col(nodes[i].value);
    far = std::max(far, x.lpNorm<Eigen::Infinity>());
    extent = std::max(extent, (x - origin).lpNorm<Eigen::Infinity>());
  }
  const double across = shape.family == Family::solid ? extent : 1.0;
  return 8.0 * std::numeric_limits<double>::epsilon() * far * extent * across;
}

Doubt doubt_of(double size, double noise) {
  if (!std::isfinite(size) || !std::isfinite(noise)) return Doubt::boundless;
  return size >= -noise ? Doubt::flat : Doubt::inverted;
}

// Elements of a block that are flat, inside out or without bounds, in order.
std::vector<DoubtfulElement> find_doubtful(const Mesh& mesh, const ElementBlock& block) {
  const Topology& shape = topology(block.shape);
  std::vector<DoubtfulElement> found;
  const auto n = static_cast<std::int64_t>(block.n_elements);
#pragma omp parallel for schedule(static) num_threads(threads_for(block.n_elements))
  for (std::int64_t e = 0; e < n; ++e) {
    const auto nodes = block.element_nodes(static_cast<std::uint32_t>(e));
    const double noise = round_off(mesh.coordinates(), nodes, shape);
    if (shape.family == Family::solid && is_plainly_sound(mesh.coordinates(), nodes, shape, noise)) continue;
    const double size = shape.family == Family::solid ? solid_volume(mesh.coordinates(), nodes, shape)
                                                      : shell_area(mesh.coordinates(), nodes, shape);
    if (size > noise && std::isfinite(size)) continue;
    const ElementIndex element{block.first_element.value + static_cast<std::uint32_t>(e)};
#pragma omp critical(contactsim_doubtful_elements)
    found.push_back({element, size, doubt_of(size, noise)});
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
  std::array<Eigen::Vector3d, max_shape_nodes> x;
  for (std::size_t i = 0; i < shape.n_shape_nodes(); ++i) x[i] = coordinates.col(nodes[i].value) - origin;
  double sum = 0.0;
  for (std::size_t side = 0; side < shape.sides.size(); ++side) {
    for (const FacetCorners& corners : shape.facets(side)) sum += cone_volume(corners, x);
  }
  return sum / 6.0;
}

void check_elements(const Mesh& mesh, std::span<const std::uint32_t> blocks) {
  ElementList inverted, flat_solids, flat_shells, boundless;
  for (std::uint32_t index : blocks) {
    check_type(mesh, index);
    const ElementBlock& block = mesh.blocks()[index];
    const Family family = topology(block.shape).family;
    if (family != Family::solid && family != Family::shell) continue;
    const std::string name = mesh.name({EntityKind::block, index});
    for (const DoubtfulElement& doubtful : find_doubtful(mesh, block)) {
      const char* what = family == Family::solid ? "volume" : "area";
      ElementList& flat = family == Family::solid ? flat_solids : flat_shells;
      ElementList& list = doubtful.doubt == Doubt::flat       ? flat
                          : doubtful.doubt == Doubt::inverted ? inverted
                                                              : boundless;
      list.add(name, mesh.element_id(doubtful.element), fmt::format("{} {:g}", what, doubtful.size));
    }
  }
  std::string text;
  const auto tell = [&](const ElementList& list, const char* what) {
    if (list.count() > 0) text += (text.empty() ? "" : "\n") + list.describe(what);
  };
  tell(inverted, "inside out");
  tell(flat_solids, "without volume");
  tell(flat_shells, "without area");
  tell(boundless, "so large that their size is no number");
  if (!text.empty()) throw FileError(mesh.path(), text);
}

}  // namespace contactsim
