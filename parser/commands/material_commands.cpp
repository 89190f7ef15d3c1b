// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/material_commands.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/materials/material_table.hpp"
#include "core/materials/traction_law_table.hpp"
#include "parser/commands/parameter_rows.hpp"
#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

constexpr const char* no_heat = "temperature has no effect on materials";

std::vector<Row<MaterialDefinition>> property_rows() {
  return {
      row("density", read::positive, &MaterialDefinition::density, "Mass per volume [mass/length^3]"),
      ignored<MaterialDefinition>("biots coefficient", "= <real>", "there is no pore pressure"),
      ignored<MaterialDefinition>("thermal strain function", "= <function>", no_heat),
      ignored<MaterialDefinition>("thermal strain x function", "= <function>", no_heat),
      ignored<MaterialDefinition>("thermal strain y function", "= <function>", no_heat),
      ignored<MaterialDefinition>("thermal strain z function", "= <function>", no_heat),
      ignored<MaterialDefinition>("thermal engineering strain function", "= <function>", no_heat),
      ignored<MaterialDefinition>("thermal log strain function", "= <function>", no_heat),
      ignored<MaterialDefinition>("thermal conductivity", "= <words>", no_heat),
      ignored<MaterialDefinition>("specific heat", "= <words>", no_heat),
  };
}

constexpr const char* model_phrase = "parameters for model";

/// A row of PARAMETERS FOR MODEL blocks. The name of a model that contactsim knows is part of the phrase.
///   model       "" of all other names
///   parameters  of the values; the table's target
Row<MaterialDefinition> model_row(const std::string& model, const std::string& help,
                                  std::span<const Parameter> parameters,
                                  const Table<ParameterValues>& table) {
  const std::string phrase = model.empty() ? model_phrase : fmt::format("{} {}", model_phrase, model);
  Row<MaterialDefinition> made{{phrase, model.empty() ? "<model>" : "", help, "none", Support::supported,
                                RowText::Matches::phrase, true,
                                [&table]() -> const TableText& { return table.text(); }}};
  made.read_block = [parameters, &table, is_unknown = model.empty()](
                        const Block& found, const DeckName&, MaterialDefinition& material, Binding& binding) {
    const std::vector<DeckName> words = block_names(found, model_phrase);
    if (words.empty()) check_name(found, {}, Naming::required);
    DeckName name{"", words.front().location};
    for (const DeckName& word : words) {
      if (!name.text.empty()) name.text += '_';
      name.text += word.text;
    }
    const bool is_known =
        find_material_row(name.text) != nullptr || find_traction_law_row(name.text) != nullptr;
    if (is_unknown && is_known) {
      throw ArgumentError{{Severity::error, "", name.location, static_cast<int>(name.text.size()) + 2,
                           fmt::format("the model '{}' is in quotes", name.text), "write it without them"}};
    }
    ParameterValues values(parameters);
    bind_block(binding, {text_of(NameKind::model).word, NameKind::model, name},
               [&](Binding& inner) { table.bind(found, values, inner); });
    material.models.push_back({std::move(name), std::move(values)});
  };
  return made;
}

/// Of models that contactsim does not know: any line is passed over.
const Table<ParameterValues>& unknown_model_table() {
  static const Table<ParameterValues> table({
      anything<ParameterValues>(
          "<name> = <value> ...", [](Arguments& arguments, ParameterValues&) { arguments.all(); },
          "A parameter of a model that contactsim does not know, passed over"),
  });
  return table;
}

/// One row per name of a model that contactsim knows and one for all others.
std::vector<Row<MaterialDefinition>> model_rows() {
  static const std::vector<Table<ParameterValues>> tables = [] {
    std::vector<Table<ParameterValues>> made;
    for (const MaterialRow& row : material_rows()) made.push_back(make_parameter_table(row.parameters));
    for (const TractionLawRow& row : traction_law_rows())
      made.push_back(make_parameter_table(row.parameters));
    return made;
  }();
  std::vector<Row<MaterialDefinition>> rows;
  std::size_t i = 0;
  for (const MaterialRow& row : material_rows()) {
    for (const std::string& name : row.names)
      rows.push_back(model_row(name, row.help, row.parameters, tables[i]));
    ++i;
  }
  for (const TractionLawRow& row : traction_law_rows())
    rows.push_back(model_row(row.name, row.help, row.parameters, tables[i++]));
  rows.push_back(
      model_row("", "Any other model: an error only when a block uses it", {}, unknown_model_table()));
  return rows;
}

bool is_enough(ElasticNeed need, int n_given) {
  return n_given == 2 || (need == ElasticNeed::none_or_two && n_given == 0) ||
         (need == ElasticNeed::one_or_two && n_given == 1);
}

}  // namespace

const Table<MaterialDefinition>& material_table() {
  static const Table<MaterialDefinition> table(joined({property_rows(), model_rows()}));
  return table;
}

void check_used_model(const MaterialDefinition& material, const MaterialModel& model,
                      Diagnostics& diagnostics) {
  const MaterialRow* row = find_material_row(model.name.text);
  if (row == nullptr) return;
  const auto fail = [&](const std::string& what, const std::string& hint) {
    diagnostics.add_error(model.name.location,
                          fmt::format("the model '{}' of the material '{}' needs {}", model.name.text,
                                      material.name.text, what),
                          hint, static_cast<int>(model.name.text.size()));
  };
  const int n_given = elastic_constants_of(model.values).n_given();
  if (!is_enough(row->elastic, n_given)) {
    fail(fmt::format("two elastic constants, found {}", n_given),
         "give two of youngs modulus, poissons ratio, shear modulus, bulk modulus, lambda");
  }
  if (row->missing_besides == nullptr) return;
  for (const std::string& phrase : row->missing_besides(model.values)) fail(fmt::format("'{}'", phrase), "");
}

void check_used_material(const MaterialDefinition& material, Diagnostics& diagnostics) {
  if (!std::isnan(material.density)) return;
  diagnostics.add_error(material.name.location,
                        fmt::format("the material '{}' has no density", material.name.text),
                        "add DENSITY = <mass per volume>", static_cast<int>(material.name.text.size()));
}

}  // namespace contactsim
