// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "core/mesh/id_lookup.hpp"
#include "io/exodus_entities.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_nodes = std::numeric_limits<std::int32_t>::max();
constexpr std::array<char, 3> axes{'x', 'y', 'z'};

NetcdfVariable require_variable(const NetcdfFile& file, const std::string& name,
                                const std::vector<std::size_t>& shape) {
  auto variable = file.find_variable(name);
  if (!variable) file.fail(fmt::format("has nodes but no coordinates (variable {})", name));
  if (variable->shape != shape)
    file.fail(fmt::format("variable {} does not match the number of nodes", name));
  return *variable;
}

// Copies one axis into its row; returns the first value that is not finite, n when all are.
std::ptrdiff_t copy_axis(std::span<const double> values, Eigen::Index axis, Eigen::Matrix3Xd& coordinates) {
  const auto n = static_cast<std::ptrdiff_t>(values.size());
  std::ptrdiff_t first_bad = n;
#pragma omp parallel for schedule(static) reduction(min : first_bad)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const double value = values[static_cast<std::size_t>(i)];
    if (!std::isfinite(value)) first_bad = std::min(first_bad, i);
    coordinates(axis, i) = value;
  }
  return first_bad;
}

bool is_counting(std::span<const std::int32_t> ids) {
  const auto n = static_cast<std::ptrdiff_t>(ids.size());
  bool counts = true;
#pragma omp parallel for schedule(static) reduction(&& : counts)
  for (std::ptrdiff_t i = 0; i < n; ++i) counts = counts && ids[static_cast<std::size_t>(i)] == i + 1;
  return counts;
}

std::vector<std::int64_t> read_wide_ids(const NetcdfFile& file, const NetcdfVariable& variable) {
  const std::size_t n = variable.size();
  if (variable.is_64_bit_integer) {
    std::vector<std::int64_t> ids(n);
    file.read_int64(variable, ids);
    return ids;
  }
  const auto narrow = std::make_unique_for_overwrite<std::int32_t[]>(n);
  const std::span<std::int32_t> values(narrow.get(), n);
  if (!file.read_int32(variable, values))
    file.fail("variable " + variable.name + " holds numbers beyond 32 bits");
  return is_counting(values) ? std::vector<std::int64_t>()
                             : std::vector<std::int64_t>(values.begin(), values.end());
}

}  // namespace

Eigen::Matrix3Xd read_coordinates(const NetcdfFile& file) {
  const std::size_t n = file.dimension("num_nodes");
  if (n > max_nodes) file.fail(fmt::format("has {} nodes; at most {} are possible", n, max_nodes));
  if (n == 0) return Eigen::Matrix3Xd(3, 0);
  const bool is_split = file.find_variable("coordx").has_value();
  const std::size_t n_values = is_split ? n : 3 * n;
  std::array<NetcdfVariable, 3> split;
  NetcdfVariable combined;
  for (std::size_t axis = 0; axis < 3 && is_split; ++axis) {
    split[axis] = require_variable(file, std::string("coord") + axes[axis], {n});
  }
  if (!is_split) combined = require_variable(file, "coord", {3, n});

  // Only after the file was found large enough for n nodes.
  Eigen::Matrix3Xd coordinates(3, static_cast<Eigen::Index>(n));
  const auto buffer = std::make_unique_for_overwrite<double[]>(n_values);
  if (!is_split) file.read_double(combined, {buffer.get(), n_values});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::span<double> values(buffer.get() + (is_split ? 0 : axis * n), n);
    if (is_split) file.read_double(split[axis], values);
    const auto bad =
        static_cast<std::size_t>(copy_axis(values, static_cast<Eigen::Index>(axis), coordinates));
    if (bad == n) continue;
    file.fail(
        fmt::format("node {} (counted from 1): its {} coordinate is {}", bad + 1, axes[axis], values[bad]));
  }
  return coordinates;
}

std::vector<std::int64_t> read_ids(const NetcdfFile& file, const std::string& variable_name, std::size_t n,
                                   const std::string& what, Diagnostics& warnings) {
  const auto variable = file.find_variable(variable_name);
  if (!variable || n == 0) return {};
  if (variable->shape != std::vector{n}) {
    file.fail(fmt::format("variable {} does not match the {} {}s of the mesh", variable_name, n, what));
  }
  std::vector<std::int64_t> ids = read_wide_ids(file, *variable);
  if (const auto repeat = IdLookup(ids).first_repeat()) {
    warn(warnings, file, "mesh-map-repeated",
         fmt::format("{} id {} is given more than once (again at {} number {}); it means the first", what,
                     ids[*repeat], what, *repeat + 1));
  }
  return ids;
}

}  // namespace contactsim
