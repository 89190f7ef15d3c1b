// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/model_tables.hpp"

#include <fmt/format.h>

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

std::vector<Row<MultilinearModel>> multilinear_rows() {
  using M = MultilinearModel;
  const auto temperature_function = [](std::string_view phrase) {
    return ignored<M>(phrase, "= <function>", "temperature has no effect on materials");
  };
  return with_elastic_rows<M>({
      row("yield stress", read::positive, &M::yield_stress, "Initial yield stress [force/length^2]"),
      row("beta", read::real, &M::beta, "Share of isotropic hardening, 0 to 1 [1]"),
      row("hardening function", read::name, &M::hardening_function,
          "Flow stress, or what is added to the yield stress, over the plastic strain; piecewise linear",
          "required"),
      temperature_function("youngs modulus function"),
      temperature_function("poissons ratio function"),
      temperature_function("yield stress function"),
  });
}

/// What multiplies the flow stress of J2_PLASTICITY; only that which changes nothing is there.
Row<J2Model> multiplier_row(std::string_view phrase, const std::string& word) {
  return row<J2Model>(
             phrase, "= " + word,
             [word](Arguments& arguments, J2Model&) { arguments.choice(std::vector{word}); },
             "Factor of the flow stress", word)
      .once();
}

/// How the flow stress of J2_PLASTICITY grows.
std::vector<Row<J2Model>> hardening_rows() {
  using J = J2Model;
  const std::vector<std::string> words{"linear", "power_law", "voce", "user_defined"};
  std::vector<std::string> all_words = words;
  all_words.push_back("decoupled_flow_stress");
  return {
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
          "piecewise linear"),
  };
}

/// Factors of that by rate and temperature.
std::vector<Row<J2Model>> factor_rows() {
  using J = J2Model;
  const auto no_rate = [](std::string_view phrase) {
    return refused<J>(phrase, "= <real>", "the flow stress does not depend on the rate; use johnson_cook");
  };
  return {
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
  };
}

}  // namespace

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

const Table<J2Model>& j2_table() {
  static const Table<J2Model> table(with_elastic_rows<J2Model>(joined({hardening_rows(), factor_rows()})));
  return table;
}

}  // namespace contactsim
