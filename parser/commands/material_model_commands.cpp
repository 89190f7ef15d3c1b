// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "parser/commands/material_commands.hpp"

#include <fmt/format.h>
#include "parser/commands/model_tables.hpp"

namespace contactsim {

namespace {

template <class Model>
const Table<Model>& elastic_only_table() {
  static const Table<Model> table(with_elastic_rows<Model>({}));
  return table;
}

const Table<MooneyRivlinModel>& mooney_rivlin_table() {
  using M = MooneyRivlinModel;
  static const Table<M> table(with_elastic_rows<M>({
      row("c10", read::real, &M::c10, "Factor of the first invariant [force/length^2]", "required"),
      row("c01", read::real, &M::c01, "Factor of the second invariant [force/length^2]", "required"),
  }));
  return table;
}

Row<OrthotropicModel> rotation_row(std::string_view phrase, AxisRotation OrthotropicModel::*rotation) {
  return row<OrthotropicModel>(
             phrase, "= {1|2|3}",
             [rotation](Arguments& arguments, OrthotropicModel& model) {
               static const std::vector<std::string> axes{"1", "2", "3"};
               (model.*rotation).axis = static_cast<std::int64_t>(arguments.choice(axes)) + 1;
             },
             "Axis about which the directions are turned", "1")
      .once();
}

Row<OrthotropicModel> angle_row(std::string_view phrase, AxisRotation OrthotropicModel::*rotation) {
  return row<OrthotropicModel>(
             phrase, "= <real>",
             [rotation](Arguments& arguments, OrthotropicModel& model) {
               (model.*rotation).angle = arguments.real();
             },
             "Angle of that turn [degrees]", "0")
      .once();
}

const Table<OrthotropicModel>& orthotropic_table() {
  using O = OrthotropicModel;
  const auto modulus = [](std::string_view key, double O::*field, std::string_view help) {
    return row(key, read::positive, field, help, "required");
  };
  const auto ratio = [](std::string_view key, double O::*field, std::string_view help) {
    return row(key, read::real, field, help, "required");
  };
  static const Table<O> table(with_elastic_rows<O>({
      modulus("e11", &O::e11, "Young's modulus along 1 [force/length^2]"),
      modulus("e22", &O::e22, "Young's modulus along 2 [force/length^2]"),
      modulus("e33", &O::e33, "Young's modulus along 3 [force/length^2]"),
      ratio("nu12", &O::nu12, "Contraction along 2 under a stress along 1 [1]"),
      ratio("nu13", &O::nu13, "Contraction along 3 under a stress along 1 [1]"),
      ratio("nu23", &O::nu23, "Contraction along 3 under a stress along 2 [1]"),
      modulus("g12", &O::g12, "Shear modulus of 1 and 2 [force/length^2]"),
      modulus("g13", &O::g13, "Shear modulus of 1 and 3 [force/length^2]"),
      modulus("g23", &O::g23, "Shear modulus of 2 and 3 [force/length^2]"),
      row("coordinate system", read::name, &O::coordinate_system,
          "System of the directions 1, 2, 3, else the global one"),
      rotation_row("direction for rotation", &O::first_rotation),
      angle_row("alpha", &O::first_rotation),
      rotation_row("second direction for rotation", &O::second_rotation),
      angle_row("second alpha", &O::second_rotation),
      ignored<O>("thermal strain 11 function", "= <function>", "temperature has no effect on materials"),
      ignored<O>("thermal strain 22 function", "= <function>", "temperature has no effect on materials"),
      ignored<O>("thermal strain 33 function", "= <function>", "temperature has no effect on materials"),
  }));
  return table;
}

bool is_separator(const Word& word) {
  return word.kind == WordKind::symbol ||
         (word.kind == WordKind::bare && (fold(word.text) == "is" || fold(word.text) == "are"));
}

bool is_value(const Word& word) { return word.kind == WordKind::quoted || is_number(word.text); }

/// The key of a line goes up to its separator, or when it has none up to the first value.
void read_parameter(Arguments& arguments, OpaqueModel& model) {
  const std::span<const Word> words = arguments.remaining();
  auto key_end = std::find_if(words.begin(), words.end(), is_separator);
  if (key_end == words.end()) key_end = std::find_if(words.begin(), words.end(), is_value);
  ModelParameter parameter{{"", arguments.location()}, {}};
  for (auto word = words.begin(); word != key_end; ++word) {
    if (!parameter.key.text.empty()) parameter.key.text += ' ';
    parameter.key.text += arguments.name().text;
  }
  arguments.skip_separator();
  if (!arguments.at_end()) parameter.values = arguments.names();
  model.parameters.push_back(std::move(parameter));
}

const Table<OpaqueModel>& opaque_table() {
  static const Table<OpaqueModel> table({
      anything<OpaqueModel>("<name> = <value> ...", read_parameter,
                            "A parameter of a model that contactsim does not know, kept as it stands"),
  });
  return table;
}

constexpr const char* model_phrase = "parameters for model";

/// The row of a model. The name of a model that contactsim knows is part of the phrase, so its row goes
/// before that of all others.
template <class Model>
Row<MaterialDefinition> model_row(const std::string& model, const Table<Model>& (*table)(),
                                  std::string help) {
  const std::string phrase = model.empty() ? model_phrase : fmt::format("{} {}", model_phrase, model);
  Row<MaterialDefinition> made{{phrase, model.empty() ? "<model>" : "", std::move(help), "none",
                                Support::supported, RowText::Matches::phrase, true,
                                [table]() -> const TableText& { return table().text(); }}};
  made.read_block = [table](const Block& found, const DeckName&, MaterialDefinition& material,
                            Binding& binding) {
    const std::vector<DeckName> words = block_names(found, model_phrase);
    if (words.empty()) check_name(found, {}, Naming::required);
    DeckName name{"", words.front().location};
    for (const DeckName& word : words) {
      if (!name.text.empty()) name.text += '_';
      name.text += word.text;
    }
    Model parameters;
    bind_block(binding, {text_of(NameKind::model).word, NameKind::model, name},
               [&](Binding& inner) { table().bind(found, parameters, inner); });
    material.models.push_back({std::move(name), std::move(parameters)});
  };
  return made;
}

}  // namespace

std::vector<Row<MaterialDefinition>> material_model_rows() {
  return {
      model_row("elastic", elastic_only_table<ElasticModel>, "Hypoelastic, finite strain"),
      model_row("linear_elastic", elastic_only_table<LinearElasticModel>, "Linear elastic, small strain"),
      model_row("neo_hookean", elastic_only_table<NeoHookeanModel>, "Hyperelastic"),
      model_row("mooney_rivlin", mooney_rivlin_table, "Hyperelastic, of two invariants"),
      model_row("elastic_orthotropic", orthotropic_table, "Hypoelastic, with directions"),
      model_row("elastic_plastic", elastic_plastic_table, "Plasticity with linear hardening"),
      model_row("ep_power_hard", power_hardening_table, "Plasticity with power-law hardening"),
      model_row("power_law_hardening", power_hardening_table, "Plasticity with power-law hardening"),
      model_row("johnson_cook", johnson_cook_table, "Plasticity with rate dependence and failure strain"),
      model_row("multilinear_ep", multilinear_table, "Plasticity with hardening along a curve"),
      model_row("ml_ep_fail", tearing_table, "The same, torn apart by plastic strain under tension"),
      model_row("j2_plasticity", j2_table,
                "Plasticity with hardening by choice: linear, power law, Voce, curve"),
      model_row("", opaque_table, "Any other model: kept, an error only when a block uses it"),
  };
}

}  // namespace contactsim
