// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/netcdf_layout.hpp"

#include <algorithm>

#include "io/netcdf/clean_text.hpp"

namespace contactsim {

namespace {

template <class Item>
const Item* find_named(const std::vector<Item>& items, std::string_view name) {
  const auto found = std::ranges::find(items, name, &Item::name);
  return found == items.end() ? nullptr : &*found;
}

}  // namespace

const NetcdfDimension* NetcdfLayout::find_dimension(std::string_view name) const {
  return find_named(dimensions, name);
}

const NetcdfDefinition* NetcdfLayout::find_variable(std::string_view name) const {
  return find_named(variables, name);
}

std::size_t NetcdfLayout::length(std::string_view dimension) const {
  const NetcdfDimension* found = find_dimension(dimension);
  return found == nullptr ? 0 : found->length;
}

std::vector<std::size_t> NetcdfLayout::shape(const NetcdfDefinition& variable) const {
  std::vector<std::size_t> lengths;
  for (const std::string& dimension : variable.dimensions) lengths.push_back(length(dimension));
  return lengths;
}

const NetcdfAttribute* find_attribute(const std::vector<NetcdfAttribute>& attributes, std::string_view name) {
  return find_named(attributes, name);
}

std::optional<double> first_number(const NetcdfAttribute* attribute) {
  if (attribute == nullptr) return std::nullopt;
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&attribute->values))
    return integers->empty() ? std::nullopt : std::optional(static_cast<double>(integers->front()));
  if (const auto* reals = std::get_if<std::vector<double>>(&attribute->values))
    return reals->empty() ? std::nullopt : std::optional(reals->front());
  return std::nullopt;
}

std::optional<std::string> whole_text(const NetcdfAttribute* attribute) {
  const auto* text = attribute == nullptr ? nullptr : std::get_if<std::vector<char>>(&attribute->values);
  if (text == nullptr) return std::nullopt;
  return clean_text({text->data(), text->size()});
}

}  // namespace contactsim
