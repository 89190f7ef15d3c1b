// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "parser/commands/material_commands.hpp"

#include <fmt/format.h>
#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

void read_poissons_ratio(Arguments& arguments, ElasticConstants& elastic) {
  const Word* written = arguments.at_end() ? nullptr : &arguments.peek();
  const double ratio = arguments.real();
  if (ratio <= -1.0 || ratio >= 0.5) {
    arguments.fail(
        *written,
        fmt::format("'poissons ratio' must be greater than -1 and less than 0.5, found '{}'", written->text));
  }
  elastic.poissons_ratio = ratio;
}

std::vector<Row<ElasticConstants>> elastic_rows() {
  using E = ElasticConstants;
  return {
      row("youngs modulus", read::positive, &E::youngs_modulus, "Young's modulus [force/length^2]"),
      row<E>("poissons ratio", "= <real > -1, < 0.5>", read_poissons_ratio, "Poisson's ratio [1]", "none")
          .once(),
      row("shear modulus", read::positive, &E::shear_modulus, "Shear modulus [force/length^2]"),
      row("bulk modulus", read::positive, &E::bulk_modulus, "Bulk modulus [force/length^2]"),
      row("lambda", read::real, &E::lambda, "Lame's first constant [force/length^2]"),
      row<E>(
          "two mu", "= <real > 0>",
          [](Arguments& arguments, E& elastic) { elastic.shear_modulus = 0.5 * arguments.positive(); },
          "Twice the shear modulus [force/length^2]", "none")
          .once(),
  };
}

/// A model's own rows after those of its elastic constants.
template <class Model>
std::vector<Row<Model>> with_elastic_rows(std::vector<Row<Model>> own_rows) {
  return joined({lift_all(elastic_rows(), &Model::elastic), std::move(own_rows)});
}

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

const Table<ElasticPlasticModel>& elastic_plastic_table() {
  using P = ElasticPlasticModel;
  static const Table<P> table(with_elastic_rows<P>({
      row("yield stress", read::positive, &P::yield_stress, "Initial yield stress [force/length^2]"),
      row("hardening modulus", read::real, &P::hardening_modulus,
          "Slope of stress over plastic strain [force/length^2]"),
      row("beta", read::real, &P::beta, "Share of isotropic hardening, 0 to 1 [1]"),
  }));
  return table;
}

const Table<PowerHardeningModel>& power_hardening_table() {
  using P = PowerHardeningModel;
  static const Table<P> table(with_elastic_rows<P>({
      row("yield stress", read::positive, &P::yield_stress, "Initial yield stress [force/length^2]"),
      row("hardening constant", read::non_negative, &P::hardening_constant,
          "Factor of the power law [force/length^2]"),
      row("hardening exponent", read::positive, &P::hardening_exponent, "Exponent of the power law [1]"),
      row("luders strain", read::non_negative, &P::luders_strain,
          "Plastic strain before hardening begins [1]"),
  }));
  return table;
}

const Table<JohnsonCookModel>& johnson_cook_table() {
  using J = JohnsonCookModel;
  static const Table<J> table(with_elastic_rows<J>({
      row("yield stress", read::positive, &J::yield_stress, "Static yield stress [force/length^2]"),
      row("hardening constant", read::non_negative, &J::hardening_constant,
          "Factor of the power law [force/length^2]"),
      row("hardening exponent", read::positive, &J::hardening_exponent, "Exponent of the power law [1]"),
      row("rate constant", read::non_negative, &J::rate_constant, "Factor of the logarithm of the rate [1]"),
      row("reference rate", read::positive, &J::reference_rate, "Strain rate of the static curve [1/time]")
          .or_spelled("edot ref"),
      row("d1", read::real, &J::d1, "Failure strain: constant part [1]"),
      row("d2", read::real, &J::d2, "Failure strain: factor of the exponential [1]"),
      row("d3", read::real, &J::d3, "Failure strain: factor of the triaxiality [1]"),
      row("d4", read::real, &J::d4, "Failure strain: factor of the logarithm of the rate [1]"),
      row("d5", read::real, &J::d5, "Failure strain: factor of the temperature [1]"),
  }));
  return table;
}

std::vector<Row<MultilinearModel>> multilinear_rows() {
  using M = MultilinearModel;
  const auto of_temperature = [](std::string_view phrase) {
    return ignored<M>(phrase, "= <function>", "temperature has no effect on materials");
  };
  return with_elastic_rows<M>({
      row("yield stress", read::positive, &M::yield_stress, "Initial yield stress [force/length^2]"),
      row("beta", read::real, &M::beta, "Share of isotropic hardening, 0 to 1 [1]"),
      row("hardening function", read::name, &M::hardening_function,
          "Flow stress, or what is added to the yield stress, over the plastic strain; piecewise linear",
          "required"),
      of_temperature("youngs modulus function"),
      of_temperature("poissons ratio function"),
      of_temperature("yield stress function"),
  });
}

const Table<MultilinearModel>& multilinear_table() {
  static const Table<MultilinearModel> table(multilinear_rows());
  return table;
}

const Table<TearingModel>& tearing_table() {
  using T = TearingModel;
  static const Table<T> table(joined<T>({
      lift_all(multilinear_rows(), &T::plastic),
      {row("critical tearing parameter", read::positive, &T::critical_tearing,
           "Tearing parameter at which a crack begins to open [1]"),
       row("critical crack opening strain", read::positive, &T::critical_opening,
           "Strain across the crack at which nothing is carried [1]")},
  }));
  return table;
}

/// What multiplies the flow stress of J2_PLASTICITY; only that which changes nothing is there.
Row<J2Model> multiplier_row(std::string_view phrase, const std::string& word) {
  return row<J2Model>(
             phrase, "= " + word, [word](Arguments& arguments, J2Model&) { arguments.choice({word}); },
             "Factor of the flow stress", word)
      .once();
}

const Table<J2Model>& j2_table() {
  using J = J2Model;
  const std::vector<std::string> words{"linear", "power_law", "voce", "user_defined"};
  std::vector<std::string> all_words = words;
  all_words.push_back("decoupled_flow_stress");
  const auto no_rate = [](std::string_view phrase) {
    return refused<J>(phrase, "= <real>", "the flow stress does not depend on the rate; use johnson_cook");
  };
  static const Table<J> table(with_elastic_rows<J>({
      row("hardening model", choice_of<HardeningModel>(all_words), &J::hardening, "How the flow stress grows",
          "required"),
      row("isotropic hardening model", choice_of<HardeningModel>(words), &J::isotropic_hardening,
          "The same, of decoupled_flow_stress"),
      row("yield stress", read::positive, &J::yield_stress, "Initial yield stress [force/length^2]"),
      row("beta", read::real, &J::beta,
          "Share of isotropic hardening, 0 to 1, of linear and user_defined [1]"),
      row("hardening modulus", read::real, &J::hardening_modulus,
          "Linear: slope of stress over plastic strain; voce: what is added in the end [force/length^2]"),
      row("exponential coefficient", read::positive, &J::exponential_coefficient,
          "Voce: one over the plastic strain in which most of it is added [1]"),
      row("hardening constant", read::non_negative, &J::hardening_constant,
          "Factor of the power law [force/length^2]"),
      row("hardening exponent", read::positive, &J::hardening_exponent, "Exponent of the power law [1]"),
      row("luders strain", read::non_negative, &J::luders_strain,
          "Plastic strain before hardening begins [1]"),
      row("hardening function", read::name, &J::hardening_function,
          "User_defined: flow stress, or what is added to the yield stress, over the plastic strain; "
          "piecewise "
          "linear"),
      multiplier_row("yield rate multiplier", "rate_independent"),
      multiplier_row("hardening rate multiplier", "rate_independent"),
      multiplier_row("yield temperature multiplier", "temperature_independent"),
      multiplier_row("hardening temperature multiplier", "temperature_independent"),
      no_rate("yield rate coefficient"),
      no_rate("yield rate exponent"),
      no_rate("yield rate constant"),
      no_rate("hardening rate coefficient"),
      no_rate("hardening rate exponent"),
      no_rate("hardening rate constant"),
      refused<J>("thermal softening model", "= <name>", "temperature has no effect on materials"),
      ignored<J>("beta_tq", "= <real>", "temperature has no effect on materials"),
      ignored<J>("specific heat", "= <real>", "temperature has no effect on materials"),
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
    bind_held(binding, model_use_key(material.name.text, name.text),
              [&](Binding& inner) { table().bind(found, parameters, inner); });
    material.models.push_back({std::move(name), std::move(parameters)});
  };
  return made;
}

}  // namespace

std::string model_use_key(std::string_view material, std::string_view model) {
  return use_key("model", fmt::format("{}/{}", material, model));
}

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
