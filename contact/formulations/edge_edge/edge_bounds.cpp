// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_bounds.hpp"

#include <algorithm>
#include <limits>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

/// More than what single precision may lose of products of lengths, speeds and sines.
constexpr float about_one = 1.0001f;

/// Share of lengths that single precision loses of what is computed of edges.
constexpr float lost_of_edges = 2e-5f;

/// From which angle on edges cross, and how far beside each other they still do over their lengths [1]: less
/// strict than find_edge_gap().
constexpr float crossing_sine_squared = 0.02f, beside_ends = 1e-4f;

}  // namespace

void EdgeBounds::update(const ContactKinematics& kinematics, std::span<const EdgeIndex> of,
                        const IndexedVector<EdgeIndex, float>& depth_before) {
  const auto& edges = kinematics.contact_mesh().edges;
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  bounds_.resize(edges.size());
  if (edges.empty()) return;
  positions_.begin(kinematics.x(edges[{0}].nodes[0]));
  const auto n = static_cast<std::uint32_t>(of.size());
  parallel_for(n, threads_for(std::size_t{10} * n), [&](std::uint32_t i) {
    const ContactEdge& edge = edges[of[i]];
    const Eigen::Vector3d from = kinematics.x(edge.nodes[0]), along = kinematics.x(edge.nodes[1]) - from;
    const Eigen::Vector3d v0 = kinematics.v(edge.nodes[0]), v1 = kinematics.v(edge.nodes[1]);
    const Eigen::Vector3f mean = (0.5 * (v0 + v1)).cast<float>();
    const Eigen::Vector3d middle = mean.cast<double>();
    const float sharp_length = edge.is_sharp() ? static_cast<float>(along.norm()) : none;
    bounds_[of[i]] = {positions_.position(from),
                      along.cast<float>(),
                      depth_before[of[i]] > 0.0f ? none : sharp_length,
                      static_cast<float>(edge.penalty_properties.thickness),
                      mean,
                      static_cast<float>(std::max((v0 - middle).norm(), (v1 - middle).norm())),
                      sharp_length};
  });
  positions_.note_rounding(n, 4.0f,
                           [&](std::uint32_t i) -> const Eigen::Vector3f& { return bounds_[of[i]].from; });
}

/// The numbers of bounds in their order.
inline RecordLanes<EdgeBounds::Bound> EdgeBounds::bounds_of(const std::array<EdgeIndex, n_float_lanes>& edges,
                                                            std::size_t n) const {
  RecordLanes<Bound> records;
  records.fill(
      n, [&](std::size_t lane) -> const auto& { return bounds_[edges[lane]]; });
  return records;
}

std::uint32_t EdgeBounds::may_touch(const Pairs& pairs, const Reach& within) const {
  const RecordLanes<Bound> of_first = bounds_of(pairs.first, pairs.n),
                           of_second = bounds_of(pairs.second, pairs.n);
  const VectorLanes a = of_first.vector(3), b = of_second.vector(3),
                    apart = of_second.vector(0) - of_first.vector(0), normal = a.cross(b);
  const FloatLanes length_a = of_first[6], length_b = of_second[6], lengths = length_a * length_b;
  const FloatLanes square = normal.dot(normal);
  const FloatLanes s = apart.cross(b).dot(normal), t = apart.cross(a).dot(normal);
  // With a size L the places along the edges are wrong by |n| |p| (e + L r) where positions are by e, and the
  // height of one edge over the other by e + L r.
  const FloatLanes error = positions_.rounding() + lost_of_edges * (taxicab(apart) + length_a + length_b);
  const FloatLanes slack = lengths * error;
  const FloatLanes slack_a = slack * length_a, slack_b = slack * length_b;
  const FloatLanes below = -beside_ends * square, above = (1.0f + beside_ends) * square;
  // Along the normal of both, whose length is the sine of their angle once the edges have a length of 1.
  const FloatLanes sine_squared_now = square / (lengths * lengths);
  const FloatLanes height = magnitude(apart.dot(normal)) / lengths - error;
  const FloatLanes speed = taxicab(of_second.vector(8) - of_first.vector(8)) + of_first[11] + of_second[11];
  const FloatLanes reach = of_first[7] * static_cast<float>(within.depth * about_one) +
                           static_cast<float>(within.shift) +
                           speed * static_cast<float>(within.time * about_one) + error;
  // Comparisons with what is not a number are false.
  const FloatMask is_far = height > 0.0f && height * height > reach * reach * sine_squared_now * about_one;
  const FloatMask beside_each_other = square <= crossing_sine_squared * lengths * lengths ||
                                      s < below - slack_b || s > above + slack_b || t < below - slack_a ||
                                      t > above + slack_a;
  return ~(is_far || beside_each_other).bits() & ((1u << pairs.n) - 1);
}

/// With a and b along the edges, p from the first to the second and n = a x b, the closest points of both
/// lines are at s = (p x b) . n / n^2 and t = (p x a) . n / n^2. Nodes that move by d change a, b and p by c
/// = 2 d at most, n by m = c (|a| + |b| + c), n^2 by m (2 |n| + m) and the numerators by what follows of
/// these.
std::uint32_t EdgeBounds::may_cross(const Pairs& pairs, double motion) const {
  const RecordLanes<Bound> of_first = bounds_of(pairs.first, pairs.n),
                           of_second = bounds_of(pairs.second, pairs.n);
  const VectorLanes a = of_first.vector(3), b = of_second.vector(3),
                    apart = of_second.vector(0) - of_first.vector(0), normal = a.cross(b);
  const FloatLanes length_a = of_first[12], length_b = of_second[12], distance = taxicab(apart);
  const FloatLanes c = 2.0f * static_cast<float>(motion) + positions_.rounding() +
                       lost_of_edges * (distance + length_a + length_b);
  const FloatLanes size_n = taxicab(normal), m = c * (length_a + length_b + c);
  const FloatLanes square = normal.dot(normal), more_square = m * (2.0f * size_n + m);
  const FloatLanes numerators = (size_n + m) * c + m * distance;
  const FloatLanes slack_s = numerators * (length_b + c) + size_n * c * distance,
                   slack_t = numerators * (length_a + c) + size_n * c * distance;
  const FloatLanes s = apart.cross(b).dot(normal), t = apart.cross(a).dot(normal);
  const FloatLanes largest_square = square + more_square, below = -beside_ends * largest_square,
                   above = (1.0f + beside_ends) * largest_square;
  const FloatLanes shortest_a = length_a - c, shortest_b = length_b - c;
  const FloatLanes least_lengths = shortest_a * shortest_b;
  // Comparisons with what is not a number are false.
  const FloatMask stay_along =
      shortest_a > 0.0f && shortest_b > 0.0f &&
      largest_square * about_one <= crossing_sine_squared * least_lengths * least_lengths;
  const FloatMask stay_beside =
      s < below - slack_s || s > above + slack_s || t < below - slack_t || t > above + slack_t;
  return ~(stay_along || stay_beside).bits() & ((1u << pairs.n) - 1);
}

}  // namespace contactsim
