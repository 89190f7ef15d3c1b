// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/node_sums.hpp"

#include "core/threads.hpp"

namespace contactsim {

NodeSums::NodeSums(std::span<const NodeIndex> connectivity, std::size_t nodes_per_element,
                   std::size_t n_nodes) {
  std::vector<std::uint32_t> next(n_nodes + 1, 0);
  for (const NodeIndex node : connectivity) ++next[node.value + 1];
  for (std::uint32_t node = 0; node < n_nodes; ++node) {
    if (next[node + 1] > 0) {
      nodes_.push_back(node);
      begin_.push_back(next[node]);
    }
    next[node + 1] += next[node];
  }
  begin_.push_back(static_cast<std::uint32_t>(connectivity.size()));
  places_.resize(connectivity.size());
  for (std::size_t i = 0; i < connectivity.size(); ++i) {
    const std::size_t element = i / nodes_per_element, corner = i % nodes_per_element;
    const std::size_t batch = element / n_lanes, lane = element % n_lanes;
    places_[next[connectivity[i].value]++] =
        static_cast<std::uint32_t>((batch * nodes_per_element + corner) * n_lanes + lane);
  }
}

void NodeSums::add(std::span<const Lanes> batch_forces, Eigen::Matrix3Xd& forces) const {
  const double* numbers = batch_forces.front().data();
  const auto n = static_cast<std::int64_t>(nodes_.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(nodes_.size()))
  for (std::int64_t i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t entry = begin_[k]; entry < begin_[k + 1]; ++entry) {
      const std::size_t place = places_[entry];
      const double* x = numbers + place / n_lanes * 3 * n_lanes + place % n_lanes;
      sum += Eigen::Vector3d(x[0], x[n_lanes], x[2 * n_lanes]);
    }
    forces.col(nodes_[k]) += sum;
  }
}

}  // namespace contactsim
