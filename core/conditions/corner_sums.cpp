// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/corner_sums.hpp"

#include <algorithm>
#include <utility>

#include "core/threads.hpp"

namespace contactsim {

CornerSums::CornerSums(std::span<const std::array<NodeIndex, 4>> faces) {
  std::vector<std::pair<NodeIndex, std::uint32_t>> corners;
  corners.reserve(4 * faces.size());
  for (std::uint32_t face = 0; face < faces.size(); ++face) {
    for (std::uint32_t corner = 0; corner < 4; ++corner)
      corners.emplace_back(faces[face][corner], 4 * face + corner);
  }
  std::sort(corners.begin(), corners.end());
  places_.reserve(corners.size());
  for (const auto& [node, place] : corners) {
    if (nodes_.empty() || nodes_.back() != node) {
      nodes_.push_back(node);
      begin_.push_back(static_cast<std::uint32_t>(places_.size()));
    }
    places_.push_back(place);
  }
  begin_.push_back(static_cast<std::uint32_t>(places_.size()));
}

void CornerSums::add(std::span<const Corners> corner_forces, Eigen::Matrix3Xd& forces) const {
  const auto n = static_cast<std::int64_t>(nodes_.size());
#pragma omp parallel for schedule(static) num_threads(threads_for(nodes_.size()))
  for (std::int64_t i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t k = begin_[at]; k < begin_[at + 1]; ++k)
      sum += corner_forces[places_[k] / 4].col(places_[k] % 4);
    forces.col(nodes_[at].value) += sum;
  }
}

}  // namespace contactsim
