// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace contactsim {

enum class NetcdfType : std::uint8_t { text, int32, int64, float32, float64 };

/// Values of any variable or attribute: characters, integers of up to 64 bits or reals of up to double
/// precision.
using NetcdfValues = std::variant<std::vector<char>, std::vector<std::int64_t>, std::vector<double>>;

struct NetcdfDimension {
  std::string name;
  std::size_t length = 0;
  bool is_unlimited = false;
};

struct NetcdfAttribute {
  std::string name;
  NetcdfType type = NetcdfType::text;
  NetcdfValues values;
};

struct NetcdfDefinition {
  std::string name;
  NetcdfType type = NetcdfType::float64;
  std::vector<std::string> dimensions;
  std::vector<NetcdfAttribute> attributes;
};

/// All that a netCDF file defines, in its order. Integers of other widths count as the next of these types.
struct NetcdfLayout {
  std::vector<NetcdfDimension> dimensions;
  std::vector<NetcdfDefinition> variables;
  std::vector<NetcdfAttribute> attributes;  ///< of the whole file

  const NetcdfDimension* find_dimension(std::string_view name) const;
  const NetcdfDefinition* find_variable(std::string_view name) const;
  /// 0 when there is none of the name.
  std::size_t length(std::string_view dimension) const;
  /// Lengths along each of its dimensions.
  std::vector<std::size_t> shape(const NetcdfDefinition& variable) const;
};

const NetcdfAttribute* find_attribute(const std::vector<NetcdfAttribute>& attributes, std::string_view name);

/// The first value of a numeric attribute.
std::optional<double> first_number(const NetcdfAttribute* attribute);

/// The text of a text attribute, cleaned (clean_text).
std::optional<std::string> whole_text(const NetcdfAttribute* attribute);

}  // namespace contactsim
