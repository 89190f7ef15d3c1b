// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/material_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "core/materials/elastic.hpp"
#include "core/materials/hardening_table.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/mooney_rivlin.hpp"
#include "core/materials/neo_hookean.hpp"
#include "core/materials/orthotropic.hpp"
#include "core/materials/tearing.hpp"

namespace contactsim {

namespace {

std::vector<MaterialRow> make_rows() {
  std::vector<MaterialRow> rows{
      elastic_material(),     linear_elastic_material(), neo_hookean_material(), mooney_rivlin_material(),
      orthotropic_material(), johnson_cook_material(),   tearing_material(),     j2_material(),
  };
  for (const HardeningRow& hardening : hardening_rows()) {
    if (!hardening.models.empty()) rows.push_back(material_of(hardening));
  }
  for (MaterialRow& row : rows) row.parameters = joined({elastic_parameters(), row.parameters});
  return rows;
}

std::string list_supported() {
  std::vector<std::string_view> names;
  for (const MaterialRow& row : material_rows()) {
    if (row.make != nullptr) names.push_back(row.names.front());
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::span<const MaterialRow> material_rows() {
  static const std::vector<MaterialRow> rows = make_rows();
  return rows;
}

const MaterialRow* find_material_row(std::string_view name) {
  const std::string wanted = fold(name);
  for (const MaterialRow& row : material_rows()) {
    if (std::ranges::find(row.names, wanted) != row.names.end()) return &row;
  }
  return nullptr;
}

std::vector<const LawKind*> material_laws() {
  std::vector<const LawKind*> laws;
  for (const MaterialRow& row : material_rows()) {
    for (const LawKind* law : row.laws) {
      if (std::ranges::find(laws, law) == laws.end()) laws.push_back(law);
    }
  }
  return laws;
}

std::optional<MaterialLaw> make_material_law(const MaterialModel& model,
                                             std::span<const FunctionDefinition> functions,
                                             Diagnostics& diagnostics) {
  const auto fail = [&](std::string_view what) {
    diagnostics.add_error(model.name.location, fmt::format("model '{}': {}", model.name.text, what), "",
                          static_cast<int>(model.name.text.size()));
    return std::nullopt;
  };
  const MaterialRow* row = find_material_row(model.name.text);
  if (row == nullptr || row->make == nullptr)
    return fail(fmt::format("the model is not supported; there are {}", list_supported()));
  try {
    return row->make({model.values, functions, diagnostics});
  } catch (const std::invalid_argument& problem) {
    return fail(problem.what());
  }
}

}  // namespace contactsim
