// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/loft_points.hpp"

#include <map>
#include <tuple>

#include "core/base/threads.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

/// What makes two vertices one point, whichever of the shells is asked.
using OffsetKey = std::tuple<NodeIndex, double, std::vector<TurnedShell>>;

OffsetKey key_of(NodeIndex node, const LoftOffset& offset, std::span<const TurnedShell> shells) {
  std::vector<TurnedShell> around(shells.begin(), shells.end());
  const bool is_turned = around.front().is_turned;
  if (is_turned) {
    for (TurnedShell& one : around) one.is_turned = !one.is_turned;
  }
  return {node, is_turned ? -offset.height : offset.height, std::move(around)};
}

std::array<NodeIndex, 4> corners_of(const Mesh& mesh, ElementIndex element) {
  const auto nodes = mesh.element_nodes(element);
  const std::size_t n =
      static_cast<std::size_t>(topology(mesh.blocks()[mesh.block_of(element)].shape).n_corners);
  return {nodes[0], nodes[1], nodes[2], nodes[n - 1]};
}

}  // namespace

LoftPoints::LoftPoints(const LoftGeometry& loft, const Mesh& mesh)
    : point_of_vertex_(loft.offsets.size()), offset_shells_(loft.offset_shells) {
  for (const ElementIndex shell : loft.shells) shell_nodes_.push_back(corners_of(mesh, shell));
  std::map<OffsetKey, std::uint32_t> known;
  for (std::size_t vertex = 0; vertex < loft.offsets.size(); ++vertex) {
    const LoftOffset& offset = loft.offsets[vertex];
    if (offset.count == 0) continue;
    const NodeIndex node = loft.node_of_vertex[vertex];
    const auto shells = std::span(offset_shells_).subspan(offset.first, offset.count);
    const auto [found, is_new] =
        known.try_emplace(key_of(node, offset, shells), static_cast<std::uint32_t>(offsets_.size()));
    point_of_vertex_[vertex] = found->second;
    if (!is_new) continue;
    nodes_.push_back(node);
    offsets_.push_back(offset);
  }
}

void LoftPoints::find_offsets(const Eigen::Matrix3Xd& coordinates, Eigen::Matrix3Xd& areas,
                              Eigen::Matrix3Xd& offsets) const {
  const auto n_shells = static_cast<std::int64_t>(shell_nodes_.size());
  areas.resize(3, n_shells);
  parallel_for(n_shells, threads_for(shell_nodes_.size()), [&](std::int64_t i) {
    const auto& nodes = shell_nodes_[static_cast<std::size_t>(i)];
    areas.col(i) = area_vector(coordinates.col(nodes[0].value), coordinates.col(nodes[1].value),
                               coordinates.col(nodes[2].value), coordinates.col(nodes[3].value));
  });
  const auto n_points = static_cast<std::int64_t>(offsets_.size());
  offsets.resize(3, n_points);
  parallel_for(n_points, threads_for(offsets_.size()), [&](std::int64_t i) {
    const LoftOffset& offset = offsets_[static_cast<std::size_t>(i)];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const TurnedShell& one : std::span(offset_shells_).subspan(offset.first, offset.count))
      sum += (one.is_turned ? -1.0 : 1.0) * areas.col(one.shell);
    offsets.col(i) = offset.height * sum.normalized();
  });
}

}  // namespace contactsim
