// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_bounds.hpp"

#include <algorithm>
#include <limits>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// More than what single precision may lose of products of lengths, speeds and sines.
constexpr float about_one = 1.0001f;

}  // namespace

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
    const Eigen::Vector3d v0 = kinematics.v(edge.nodes[0]), v1 = kinematics.v(edge.nodes[1]);
    const Eigen::Vector3f mean = (0.5 * (v0 + v1)).cast<float>();
    const Eigen::Vector3d middle = mean.cast<double>();
    const bool counts_always = !edge.is_sharp() || depth_before[{i}] > 0.0f;
    bounds_[{i}] = {
        positions_.position(from),
        along.cast<float>(),
        counts_always ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(along.norm()),
        static_cast<float>(edge.penalty_properties.thickness),
        mean,
        static_cast<float>(std::max((v0 - middle).norm(), (v1 - middle).norm()))};
  });
  positions_.note_rounding(n, 4.0f,
                           [&](std::uint32_t i) -> const Eigen::Vector3f& { return bounds_[{i}].from; });
}

std::uint32_t EdgeBounds::may_touch(const Pairs& pairs, double ahead, double offset) const {
  RecordLanes<Bound> of_first, of_second;  // the numbers of a bound in its order
  of_first.fill(
      pairs.n, [&](std::size_t lane) -> const auto& { return bounds_[pairs.first[lane]]; });
  of_second.fill(
      pairs.n, [&](std::size_t lane) -> const auto& { return bounds_[pairs.second[lane]]; });
  const VectorLanes a = of_first.vector(3), b = of_second.vector(3),
                    apart = of_second.vector(0) - of_first.vector(0), normal = a.cross(b);
  const FloatLanes length_a = of_first[6], length_b = of_second[6], lengths = length_a * length_b;
  // From which angle on edges cross, and how far beside each other they still do over their lengths [1]: less
  // strict than find_edge_gap().
  constexpr float sine_squared = 0.02f, beside = 1e-4f;
  const FloatLanes square = normal.dot(normal);
  const FloatLanes s = apart.cross(b).dot(normal), t = apart.cross(a).dot(normal);
  // With a size L the places along the edges are wrong by |n| |p| (e + L r) where positions are by e, and the
  // height of one edge over the other by e + L r.
  const FloatLanes error = positions_.rounding() + 2e-5f * (taxicab(apart) + length_a + length_b);
  const FloatLanes slack = lengths * error;
  const FloatLanes slack_a = slack * length_a, slack_b = slack * length_b;
  const FloatLanes below = -beside * square, above = (1.0f + beside) * square;
  // Along the normal of both, whose length is the sine of their angle once the edges have a length of 1.
  const FloatLanes sine_squared_now = square / (lengths * lengths);
  const FloatLanes height = magnitude(apart.dot(normal)) / lengths - error;
  const FloatLanes speed = taxicab(of_second.vector(8) - of_first.vector(8)) + of_first[11] + of_second[11];
  const FloatLanes reach =
      of_first[7] + static_cast<float>(offset) + speed * static_cast<float>(ahead * about_one) + error;
  // Comparisons with what is not a number are false.
  const FloatMask is_far = height > 0.0f && height * height > reach * reach * sine_squared_now * about_one;
  const FloatMask beside_each_other = square <= sine_squared * lengths * lengths || s < below - slack_b ||
                                      s > above + slack_b || t < below - slack_a || t > above + slack_a;
  return ~(is_far || beside_each_other).bits() & ((1u << pairs.n) - 1);
}

}  // namespace contactsim
