// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/file_layout.hpp"

#include <algorithm>

#include "io/netcdf/netcdf_output.hpp"

namespace contactsim {

namespace {

std::size_t bytes_of(NetcdfType type) {
  if (type == NetcdfType::text) return 1;
  return type == NetcdfType::int64 || type == NetcdfType::float64 ? 8 : 4;
}

}  // namespace

NetcdfLayout make_writable(const NetcdfLayout& layout) {
  NetcdfLayout writable;
  writable.attributes = layout.attributes;
  for (NetcdfDimension dimension : layout.dimensions) {
    dimension.is_unlimited = dimension.is_unlimited && dimension.name == "time_step";
    if (dimension.length > 0 || dimension.is_unlimited) writable.dimensions.push_back(dimension);
  }
  for (const NetcdfDefinition& variable : layout.variables) {
    const bool is_empty = std::ranges::any_of(variable.dimensions, [&](const std::string& dimension) {
      return writable.find_dimension(dimension) == nullptr;
    });
    if (!is_empty) writable.variables.push_back(variable);
  }
  return writable;
}

bool needs_large_file(const NetcdfLayout& layout) {
  return std::ranges::any_of(layout.variables, [&](const NetcdfDefinition& variable) {
    if (variable.type == NetcdfType::int64) return true;
    std::size_t bytes = bytes_of(variable.type);
    for (const std::string& name : variable.dimensions) {
      const NetcdfDimension* dimension = layout.find_dimension(name);
      if (!dimension->is_unlimited) bytes *= dimension->length;
    }
    return bytes > NetcdfOutput::largest_plain_variable;
  });
}

bool is_record(const NetcdfLayout& layout, const NetcdfDefinition& variable) {
  if (variable.dimensions.empty()) return false;
  const NetcdfDimension* first = layout.find_dimension(variable.dimensions.front());
  return first != nullptr && first->name == "time_step";
}

}  // namespace contactsim
