// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_bounds.hpp"

#include <limits>

#include "core/base/threads.hpp"

namespace contactsim {

void EdgeBounds::update(const ContactKinematics& kinematics,
                        const IndexedVector<EdgeIndex, float>& depth_before) {
  const auto& edges = kinematics.contact_mesh().edges;
  const auto n = static_cast<std::uint32_t>(edges.size());
  bounds_.resize(n);
  if (n == 0) return;
  const Eigen::Vector3d origin = kinematics.x(edges[{0}].nodes[0]);
  parallel_for(n, threads_for(n), [&](std::uint32_t i) {
    const ContactEdge& edge = edges[{i}];
    const Eigen::Vector3d from = kinematics.x(edge.nodes[0]), along = kinematics.x(edge.nodes[1]) - from;
    const bool counts_always = !edge.is_sharp() || depth_before[{i}] > 0.0f;
    bounds_[{i}] = {
        (from - origin).cast<float>(), along.cast<float>(),
        counts_always ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(along.norm())};
  });
  const float farthest = parallel_max(
      n, threads_for(n), 0.0f, [&](std::uint32_t i) { return bounds_[{i}].from.lpNorm<Eigen::Infinity>(); });
  rounding_ = 4.0f * 0x1p-24f * farthest;
}

}  // namespace contactsim
