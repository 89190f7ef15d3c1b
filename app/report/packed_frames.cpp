// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/packed_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contactsim {

namespace {

constexpr std::size_t max_frames = 120, first_try = 6;
constexpr std::size_t max_numbers = 40'000'000;  // of one field, all frames
constexpr std::size_t many_faces = 20'000;
constexpr double screen_steps = 8192.0, motion_steps = 1024.0, largest_code = 1e9;

std::vector<std::size_t> choose_evenly(std::size_t n, std::size_t n_chosen) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < n_chosen; ++i)
    chosen.push_back(n_chosen < 2 ? n - 1 : i * (n - 1) / (n_chosen - 1));
  return chosen;
}

/// The largest distance between two corners of the box around what is drawn.
double size_of(const FrameInput& input) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const NodeIndex node : input.geometry.nodes) {
    low = low.cwiseMin(input.mesh.coordinates().col(node.value));
    high = high.cwiseMax(input.mesh.coordinates().col(node.value));
  }
  return input.geometry.nodes.empty() ? 0.0 : (high - low).norm();
}

void pack_displacement(const FrameInput& input, PackedFrames& packed) {
  if (!input.fields.displacement) return;
  const auto& nodes = input.geometry.nodes;
  std::vector<float> all;
  all.reserve(packed.chosen.size() * 3 * nodes.size());
  double largest = 0.0;
  for (const std::size_t time : packed.chosen) {
    const Eigen::Matrix3Xd moved = input.fields.displacement(time);
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (const NodeIndex node : nodes) {
        const double value = moved(row, node.value);
        all.push_back(static_cast<float>(std::isfinite(value) ? value : 0.0));
        largest = std::max(largest, std::abs(static_cast<double>(all.back())));
      }
    }
  }
  if (largest == 0.0) return;
  const double step =
      std::max(std::min(size_of(input) / screen_steps, largest / motion_steps), largest / largest_code);
  packed.displacement_step = step;
  std::vector<std::int64_t> codes(all.size());
  std::ranges::transform(all, codes.begin(), [&](float value) { return std::llround(value / step); });
  packed.displacement = pack_numbers(codes, 3 * nodes.size(), true);
}

/// The values of what is drawn, time by time.
std::vector<float> read_values(const FrameInput& input, const ReportField& field,
                               const std::vector<std::size_t>& chosen) {
  std::vector<float> all;
  for (const std::size_t time : chosen) {
    const std::vector<double> values = field.read(time);
    if (field.is_nodal) {
      for (const NodeIndex node : input.geometry.nodes) all.push_back(static_cast<float>(values[node.value]));
    } else {
      for (const ReportFace& face : input.geometry.faces)
        all.push_back(static_cast<float>(values[face.element.value]));
    }
  }
  return all;
}

/// Where a scale is to bend so that a few values that pass all others by far do not hide these: a pressure on
/// a corner, say. 0: nowhere.
double find_linear_part(const std::vector<float>& values, double largest) {
  std::vector<float> sizes;
  for (const float value : values) {
    if (std::isfinite(value) && value != 0.0f) sizes.push_back(std::abs(value));
  }
  if (sizes.empty()) return 0.0;
  const auto most = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 98 / 100);
  std::ranges::nth_element(sizes, most);
  constexpr double far = 5.0, linear_share = 0.1;
  return largest > far * *most ? linear_share * *most : 0.0;
}

PackedField pack_field(const FrameInput& input, const ReportField& field,
                       const std::vector<std::size_t>& chosen) {
  const std::vector<float> values = read_values(input, field, chosen);
  double lowest = std::numeric_limits<double>::max(), highest = -lowest;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, static_cast<double>(value));
    highest = std::max(highest, static_cast<double>(value));
  }
  if (lowest > highest) lowest = highest = 0.0;
  const double n_steps = input.geometry.faces.size() > many_faces ? 254.0 : 4094.0;
  const double linear = find_linear_part(values, std::max(-lowest, highest));
  PackedField packed{field.name, field.is_nodal, {lowest, highest, n_steps, linear}, lowest, highest, ""};
  std::vector<std::int64_t> codes(values.size());
  std::ranges::transform(values, codes.begin(), [&](float value) {
    return std::isfinite(value) ? packed.scale.code(value) + 1 : 0;
  });
  const std::size_t n_columns = codes.size() / chosen.size();
  if (n_columns > 0) packed.numbers = pack_numbers(codes, n_columns, true);
  return packed;
}

PackedFrames pack(const FrameInput& input, std::size_t n_frames) {
  PackedFrames packed;
  packed.chosen = choose_evenly(input.n_times, n_frames);
  pack_displacement(input, packed);
  for (const ReportField& field : input.fields.fields)
    packed.fields.push_back(pack_field(input, field, packed.chosen));
  return packed;
}

}  // namespace

std::size_t PackedFrames::bytes() const {
  std::size_t sum = displacement.size();
  for (const PackedField& field : fields) sum += field.numbers.size();
  return sum;
}

PackedFrames pack_frames(const FrameInput& input, std::size_t max_bytes) {
  const std::size_t n_numbers = std::max<std::size_t>(1, 3 * input.geometry.nodes.size());
  const std::size_t least = std::min<std::size_t>(2, input.n_times);
  const std::size_t most = std::max(least, std::min({input.n_times, max_frames, max_numbers / n_numbers}));
  std::size_t n_frames = std::min(most, std::max(least, first_try));
  if (n_frames == 0) return {};
  PackedFrames packed = pack(input, n_frames);
  bool may_grow = true;
  for (;;) {
    const double share = static_cast<double>(max_bytes) / static_cast<double>(packed.bytes() + 1);
    const auto wanted = static_cast<std::size_t>(static_cast<double>(n_frames) * std::min(share, 100.0));
    const bool is_too_large = packed.bytes() > max_bytes;
    const bool has_room = may_grow && wanted > n_frames;
    const std::size_t next = std::clamp(is_too_large ? std::min(wanted, n_frames - 1) : wanted, least, most);
    if (next == n_frames || !(is_too_large || has_room)) return packed;
    may_grow = may_grow && !is_too_large;
    n_frames = next;
    packed = pack(input, n_frames);
  }
}

}  // namespace contactsim
