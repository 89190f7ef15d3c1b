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
  positions_.begin(kinematics.x(edges[{0}].nodes[0]));
  parallel_for(n, threads_for(n), [&](std::uint32_t i) {
    const ContactEdge& edge = edges[{i}];
    const Eigen::Vector3d from = kinematics.x(edge.nodes[0]), along = kinematics.x(edge.nodes[1]) - from;
    const bool counts_always = !edge.is_sharp() || depth_before[{i}] > 0.0f;
    bounds_[{i}] = {
        positions_.position(from), along.cast<float>(),
        counts_always ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(along.norm())};
  });
  positions_.note_rounding(n, 4.0f,
                           [&](std::uint32_t i) -> const Eigen::Vector3f& { return bounds_[{i}].from; });
}

std::uint32_t EdgeBounds::may_cross(const Pairs& pairs) const {
  RecordLanes<Bound> of_first, of_second;
  for (std::size_t lane = 0; lane < pairs.n; ++lane) {
    of_first.set(lane, bounds_[pairs.first[lane]]);
    of_second.set(lane, bounds_[pairs.second[lane]]);
  }
  const VectorLanes a = of_first.vector(3), b = of_second.vector(3),
                    apart = of_second.vector(0) - of_first.vector(0), normal = a.cross(b);
  const FloatLanes length_a = of_first[6], length_b = of_second[6], lengths = length_a * length_b;
  // From which angle on edges cross, and how far beside each other they still do over their lengths [1]: less
  // strict than find_edge_gap().
  constexpr float sine_squared = 0.02f, beside = 1e-4f;
  const FloatLanes square = normal.dot(normal);
  const FloatLanes s = apart.cross(b).dot(normal), t = apart.cross(a).dot(normal);
  // With a size L the places along the edges are wrong by |n| |p| (e + L r) where positions are by e.
  const FloatLanes size = magnitude(apart.x) + magnitude(apart.y) + magnitude(apart.z) + length_a + length_b;
  const FloatLanes slack = lengths * (positions_.rounding() + 2e-5f * size);
  const FloatLanes slack_a = slack * length_a, slack_b = slack * length_b;
  const FloatLanes below = -beside * square, above = (1.0f + beside) * square;
  // Comparisons with what is not a number are false.
  const TruthLanes beside_each_other = (square <= sine_squared * lengths * lengths) | (s < below - slack_b) |
                                       (s > above + slack_b) | (t < below - slack_a) | (t > above + slack_a);
  return ~bits_of(beside_each_other) & ((1u << pairs.n) - 1);
}

}  // namespace contactsim
