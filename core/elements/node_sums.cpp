// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/node_sums.hpp"

#include "core/threads.hpp"

namespace contactsim {

NodeSums::NodeSums(std::span<const NodeIndex> connectivity, std::size_t nodes_per_element,
                   std::size_t n_nodes)
    : component_stride_(nodes_per_element * n_lanes) {
  std::vector<std::uint64_t> next(n_nodes + 1, 0);
  for (const NodeIndex node : connectivity) ++next[node.value + 1];
  for (std::uint32_t node = 0; node < n_nodes; ++node) {
    if (next[node + 1] > 0) {
      nodes_.push_back(node);
      begin_.push_back(next[node]);
    }
    next[node + 1] += next[node];
  }
  begin_.push_back(connectivity.size());
  places_.resize(connectivity.size());
  for (std::size_t i = 0; i < connectivity.size(); ++i) {
    const std::size_t element = i / nodes_per_element, corner = i % nodes_per_element;
    const std::size_t batch = element / n_lanes, lane = element % n_lanes;
    places_[next[connectivity[i].value]++] = batch * 3 * component_stride_ + corner * n_lanes + lane;
  }
}

void NodeSums::add(std::span<const double> batch_forces, Eigen::Matrix3Xd& forces) const {
  const auto n = static_cast<std::int64_t>(nodes_.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(nodes_.size()))
  for (std::int64_t i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint64_t entry = begin_[k]; entry < begin_[k + 1]; ++entry) {
      const double* x = batch_forces.data() + places_[entry];
      sum += Eigen::Vector3d(x[0], x[component_stride_], x[2 * component_stride_]);
    }
    forces.col(nodes_[k]) += sum;
  }
}

}  // namespace contactsim
