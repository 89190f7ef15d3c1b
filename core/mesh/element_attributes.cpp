// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/element_attributes.hpp"

#include <algorithm>
#include <numeric>

#include "core/base/names.hpp"

namespace contactsim {

bool has_attribute_names(const ElementBlock& block) {
  return std::any_of(block.attribute_names.begin(), block.attribute_names.end(),
                     [](const std::string& name) { return !name.empty(); });
}

std::optional<double> find_named_attribute(const ElementBlock& block, std::uint32_t element,
                                           std::string_view name) {
  const auto& names = block.attribute_names;
  const auto named =
      std::find_if(names.begin(), names.end(), [&](const std::string& a) { return fold(a) == fold(name); });
  if (named == names.end()) return std::nullopt;
  return block.attributes[element * names.size() + static_cast<std::size_t>(named - names.begin())];
}

std::optional<double> find_usual_attribute(const ElementBlock& block, std::uint32_t element,
                                           std::string_view name) {
  const std::size_t n = block.attribute_names.size();
  if (n == 0) return std::nullopt;
  if (const auto named = find_named_attribute(block, element, name)) return named;
  const double* values = block.attributes.data() + element * n;
  const bool is_nodal =
      topology(block.shape).family == Family::shell && n == static_cast<std::size_t>(block.nodes_per_element);
  return is_nodal ? std::accumulate(values, values + n, 0.0) / static_cast<double>(n) : values[0];
}

}  // namespace contactsim
