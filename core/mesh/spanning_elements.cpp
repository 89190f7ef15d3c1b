// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/spanning_elements.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace contactsim {

namespace {

constexpr double large_share = 0.5;         // of the model's extent
constexpr double times_as_large = 20.0;     // as the median of its block
constexpr std::uint32_t few_elements = 50;  // a median of fewer says little

double extent_of(const Eigen::Matrix3Xd& coordinates, std::span<const NodeIndex> nodes) {
  if (nodes.empty()) return 0.0;
  Eigen::Vector3d low = coordinates.col(nodes.front().value), high = low;
  for (const NodeIndex node : nodes.subspan(1)) {
    low = low.cwiseMin(coordinates.col(node.value));
    high = high.cwiseMax(coordinates.col(node.value));
  }
  return (high - low).maxCoeff();
}

std::vector<double> extents_of(const Mesh& mesh, const ElementBlock& block) {
  std::vector<double> extents(block.n_elements);
  for (std::uint32_t e = 0; e < block.n_elements; ++e)
    extents[e] = extent_of(mesh.coordinates(), block.element_nodes(e));
  return extents;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<SpanningElements> find_spanning_elements(const Mesh& mesh) {
  if (mesh.n_nodes() == 0) return std::nullopt;
  const auto& x = mesh.coordinates();
  const double whole = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
  SpanningElements found;
  for (const ElementBlock& block : mesh.blocks()) {
    if (block.n_elements < few_elements) continue;
    const std::vector<double> extents = extents_of(mesh, block);
    if (!(*std::max_element(extents.begin(), extents.end()) > large_share * whole)) continue;
    const double usual = median_of(extents);
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      if (!(extents[e] > std::max(large_share * whole, times_as_large * usual))) continue;
      if (found.n++ == 0) found = {1, {block.first_element.value + e}, extents[e], usual};
    }
  }
  return found.n > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace contactsim
