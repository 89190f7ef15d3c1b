// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_attributes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

std::vector<std::string> usual_names(const ElementBlock& block, std::size_t n_attributes) {
  const Family family = topology(block.shape).family;
  if (fold(block.type_name).starts_with("sphere-mass")) {
    return {"mass",       "inertia_xx", "inertia_yy", "inertia_zz", "inertia_xy",
            "inertia_yz", "inertia_zx", "offset_x",   "offset_y",   "offset_z"};
  }
  if (family == Family::particle) return {"radius", "volume"};
  if (block.shape == Shape::beam2 || block.shape == Shape::beam3) {
    return {
        "area",     "i1",       "i2",      "j", "reference_axis_x", "reference_axis_y", "reference_axis_z",
        "offset_x", "offset_y", "offset_z"};
  }
  if (family == Family::line) return {"area"};
  if (family != Family::shell) return {};
  if (n_attributes != static_cast<std::size_t>(block.nodes_per_element)) return {"thickness"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= n_attributes; ++i) names.push_back(fmt::format("nodal_thickness_{}", i));
  return names;
}

}  // namespace

std::vector<std::string> default_attribute_names(const ElementBlock& block, std::size_t n_attributes) {
  std::vector<std::string> names = usual_names(block, n_attributes);
  names.resize(std::min(names.size(), n_attributes));
  while (names.size() < n_attributes) names.push_back(fmt::format("attribute_{}", names.size() + 1));
  return names;
}

}  // namespace contactsim
