// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "core/mesh/id_lookup.hpp"
#include "io/exodus/exodus_conventions.hpp"
#include "io/exodus/exodus_entities.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_nodes = std::numeric_limits<std::int32_t>::max();
constexpr std::array<char, 3> axes{'x', 'y', 'z'};

NetcdfVariable require_variable(const ExodusFile& file, const std::string& name,
                                const std::vector<std::size_t>& shape) {
  auto variable = file.find_variable(name);
  if (!variable) file.fail(fmt::format("has nodes but no coordinates (variable {})", name));
  if (variable->shape != shape)
    file.fail(fmt::format("variable {} does not match the number of nodes", name));
  return *variable;
}

// Puts values of one axis at their nodes, the first of which is given.
void copy_axis(const ExodusFile& file, std::span<const double> values, std::size_t axis, std::size_t first,
               Eigen::Matrix3Xd& coordinates) {
  double* target = coordinates.data() + 3 * first + axis;
  unsigned is_bad = 0;
  for (double value : values) {
    is_bad |= std::abs(value) <= std::numeric_limits<double>::max() ? 0u : 1u;
    *target = value;
    target += 3;
  }
  if (is_bad == 0) return;
  const auto bad =
      std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  const std::size_t node = first + static_cast<std::size_t>(bad - values.begin());
  file.fail(fmt::format("node {} (counted from 1): its {} coordinate is {}", node + 1, axes[axis], *bad));
}

// coordx, coordy, coordz: parts of all three in turn, so that each node's cache line is filled at once.
void read_split(const ExodusFile& file, std::size_t n, Eigen::Matrix3Xd& coordinates) {
  std::array<NetcdfVariable, 3> variables;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    variables[axis] = require_variable(file, std::string("coord") + axes[axis], {n});
  }
  coordinates.resize(3, static_cast<Eigen::Index>(n));
  const std::size_t n_at_once =
      std::min(n, std::max({file.rows_per_read(variables[0]), file.rows_per_read(variables[1]),
                            file.rows_per_read(variables[2])}));
  const auto buffer = std::make_unique_for_overwrite<double[]>(n_at_once);
  for (std::size_t first = 0; first < n; first += n_at_once) {
    const std::span<double> values(buffer.get(), std::min(n_at_once, n - first));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      file.read_double(variables[axis], {first, values.size()}, values);
      copy_axis(file, values, axis, first, coordinates);
    }
  }
}

// coord: all of x, then all of y, then all of z.
void read_combined(const ExodusFile& file, std::size_t n, Eigen::Matrix3Xd& coordinates) {
  const NetcdfVariable variable = require_variable(file, "coord", {3, n});
  coordinates.resize(3, static_cast<Eigen::Index>(n));
  const auto buffer = std::make_unique_for_overwrite<double[]>(n);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    file.read_double(variable, {axis, 1}, {buffer.get(), n});
    copy_axis(file, {buffer.get(), n}, axis, 0, coordinates);
  }
}

std::vector<std::int64_t> read_wide_ids(const ExodusFile& file, const NetcdfVariable& variable) {
  const std::size_t n = variable.size();
  if (variable.is_64_bit_integer) {
    std::vector<std::int64_t> ids(n);
    file.read_int64(variable, ids);
    return ids;
  }
  const auto narrow = std::make_unique_for_overwrite<std::int32_t[]>(n);
  const std::span<std::int32_t> values(narrow.get(), n);
  if (!file.read_int32(variable, {0, n}, values)) {
    file.fail("variable " + variable.name + " holds numbers beyond 32 bits");
  }
  return is_counting<std::int32_t>(values) ? std::vector<std::int64_t>()
                                           : std::vector<std::int64_t>(values.begin(), values.end());
}

}  // namespace

Eigen::Matrix3Xd read_coordinates(const ExodusFile& file) {
  const std::size_t n = file.dimension("num_nodes");
  if (n > max_nodes) file.fail(fmt::format("has {} nodes; at most {} are possible", n, max_nodes));
  Eigen::Matrix3Xd coordinates(3, 0);
  if (n == 0) return coordinates;
  if (file.find_variable("coordx")) {
    read_split(file, n, coordinates);
  } else {
    read_combined(file, n, coordinates);
  }
  return coordinates;
}

std::vector<std::int64_t> read_ids(const ExodusFile& file, const std::string& variable_name, std::size_t n,
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
