// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/friction_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"

namespace contactsim {

namespace {

/// A second model of one name that says the same as the first does no harm.
void add_model(ContactDefinition& contact, FrictionModel model, Binding& binding) {
  const auto first = std::find_if(contact.friction_models.begin(), contact.friction_models.end(),
                                  [&](const FrictionModel& other) { return other.name == model.name; });
  if (first != contact.friction_models.end() && first->law == model.law && binding.names != nullptr) {
    binding.names->drop_block();
    binding.diagnostics.add_warning(
        "deck-duplicate", model.name.location,
        fmt::format("the friction model '{}' is defined twice, with equal content", model.name.text),
        "the first stands at " + to_string(first->name.location), static_cast<int>(model.name.text.size()));
  }
  contact.friction_models.push_back(std::move(model));
}

/// A block that defines a friction model with the law that its table binds.
///   law_of_type  the law before any line of the block is read
template <class Law>
Row<ContactDefinition> friction_block(std::string phrase, const Table<Law>& (*table)(), std::string help,
                                      const Law& law_of_type = {}) {
  Row<ContactDefinition> made{{std::move(phrase), syntax_of(Naming::required), std::move(help), "none",
                               Support::supported, RowText::Matches::phrase, true,
                               [table]() -> const TableText& { return table().text(); }}};
  made.read_block = [table, law_of_type](const Block& found, const DeckName& name, ContactDefinition& contact,
                                         Binding& binding) {
    check_name(found, name, Naming::required);
    Law law = law_of_type;
    table().bind(found, law, binding);
    add_model(contact, {name, std::move(law)}, binding);
  };
  return std::move(made).defines(NameKind::friction_model);
}

/// Of laws without parameters.
template <class Law>
const Table<Law>& empty_table() {
  static const Table<Law> table(std::vector<Row<Law>>{});
  return table;
}

const Table<ConstantFriction>& constant_friction_table() {
  static const Table<ConstantFriction> table({
      row("friction coefficient", read::non_negative, &ConstantFriction::coefficient,
          "Coulomb coefficient: largest tangential over normal force [1]"),
  });
  return table;
}

template <class T>
std::vector<Row<T>> failure_rows(WeldFailure T::*failure) {
  using W = WeldFailure;
  return lift_all<T, W>(
      {
          row("failure decay cycles", read::positive_integer, &W::decay_cycles,
              "Steps [1] over which the force fades after failure"),
          row("failed model", read::name_of(NameKind::friction_model), &W::failed_model,
              "Friction model after failure", "frictionless"),
      },
      failure);
}

template <class T>
Row<T> envelope_exponent_row() {
  return row("failure envelope exponent", read::positive, &T::envelope_exponent,
             "Exponent p of the failure envelope (normal part)^p + (tangential part)^p = 1 [1]");
}

const Table<SpringWeld>& spring_weld_table() {
  using W = SpringWeld;
  static const Table<W> table(joined<W>({
      first_required(scaled_function_rows("normal displacement", &W::normal,
                                          "of opening [length]: the normal force [force]")),
      first_required(scaled_function_rows("tangential displacement", &W::tangential,
                                          "of slip [length]: the tangential force [force]")),
      {envelope_exponent_row<W>()},
      failure_rows(&W::failure),
  }));
  return table;
}

/// Of surface welds (capacities are forces) and area welds (tractions).
template <bool is_per_area>
const Table<SurfaceWeld>& surface_weld_table() {
  using W = SurfaceWeld;
  const std::string dimension = is_per_area ? "traction [force/length^2]" : "force [force]";
  static const Table<W> table(joined<W>({
      {
          row("normal capacity", read::positive, &W::normal_capacity,
              "Normal " + dimension + " that breaks the weld")
              .required(),
          row("tangential capacity", read::positive, &W::tangential_capacity,
              "Tangential " + dimension + " that breaks the weld")
              .required(),
      },
      failure_rows(&W::failure),
  }));
  return table;
}

SurfaceWeld area_weld() {
  SurfaceWeld weld;
  weld.is_per_area = true;
  return weld;
}

const Table<Adhesion>& adhesion_table() {
  static const Table<Adhesion> table(first_required(scaled_function_rows(
      "adhesion", &Adhesion::adhesion, "of the gap [length]: the traction that holds it [force/length^2]")));
  return table;
}

const Table<CohesiveZone>& cohesive_zone_table() {
  using Z = CohesiveZone;
  static const Table<Z> table(joined<Z>({
      first_required(
          scaled_function_rows("traction displacement", &Z::traction,
                               "of the opening over the critical one [1]: the traction [force/length^2]")),
      {
          row("critical normal gap", read::positive, &Z::critical_normal_gap,
              "Normal opening at failure [length]")
              .required(),
          row("critical tangential gap", read::positive, &Z::critical_tangential_gap,
              "Tangential opening at failure [length]")
              .required(),
      },
  }));
  return table;
}

const Table<Junction>& junction_table() {
  using J = Junction;
  static const Table<J> table(joined<J>({
      first_required(scaled_function_rows("normal traction", &J::normal,
                                          "of the gap [length]: the traction [force/length^2]")),
      first_required(
          scaled_function_rows("tangential traction", &J::tangential,
                               "of the slip rate [length/time]: the largest traction [force/length^2]")),
      {row("normal cutoff distance for tangential traction", read::non_negative, &J::tangential_cutoff,
           "Gap from which on there is no tangential traction [length]", "where the normal function ends")},
  }));
  return table;
}

const Table<Threaded>& threaded_table() {
  using T = Threaded;
  static const Table<T> table(joined<T>({
      first_required(scaled_function_rows("normal traction", &T::normal,
                                          "of the gap [length]: the traction [force/length^2]")),
      first_required(scaled_function_rows("tangential traction", &T::tangential,
                                          "of the slip [length]: the traction [force/length^2]")),
      scaled_function_rows("tangential traction gap", &T::tangential_gap,
                           "of the gap [length]: a factor of the tangential traction [1]"),
      {
          row("normal capacity", read::positive, &T::normal_capacity,
              "Normal traction at failure [force/length^2]")
              .required(),
          row("tangential capacity", read::positive, &T::tangential_capacity,
              "Tangential traction at failure [force/length^2]")
              .required(),
          envelope_exponent_row<T>(),
      },
      failure_rows(&T::failure),
  }));
  return table;
}

const Table<PressureVelocityFriction>& pressure_velocity_table() {
  using P = PressureVelocityFriction;
  static const Table<P> table({
      row("static coefficient", read::non_negative, &P::static_coefficient, "Coefficient at rest [1]"),
      row("dynamic coefficient", read::non_negative, &P::dynamic_coefficient,
          "Coefficient at high slip rate [1]"),
      row("velocity decay", read::non_negative, &P::velocity_decay,
          "How fast the coefficient falls with the slip rate [time/length]"),
      row("reference pressure", read::positive, &P::reference_pressure,
          "Pressure that the sum of pressure and offset is measured by [force/length^2]")
          .required(),
      row("offset pressure", read::non_negative, &P::offset_pressure,
          "Added to the pressure [force/length^2]"),
      row("pressure exponent", read::real, &P::pressure_exponent, "Power of the relative pressure [1]"),
  });
  return table;
}

const Table<HybridFriction>& hybrid_table() {
  using H = HybridFriction;
  static const Table<H> table({
      row("initially close", read::name_of(NameKind::friction_model), &H::initially_close,
          "Friction model where the sides touch at the start", "frictionless"),
      row("initially far", read::name_of(NameKind::friction_model), &H::initially_far,
          "Friction model everywhere else", "frictionless"),
  });
  return table;
}

void read_period_model(Arguments& arguments, TimeVariantFriction& friction) {
  PeriodModel model{arguments.reference(NameKind::friction_model), {}};
  arguments.expect("during");
  if (!arguments.accept("period")) arguments.expect("periods");
  arguments.skip_separator();
  model.periods = arguments.references(NameKind::time_stepping_block);
  friction.models.push_back(std::move(model));
}

const Table<TimeVariantFriction>& time_variant_table() {
  static const Table<TimeVariantFriction> table({
      row<TimeVariantFriction>("model", "= <model> DURING PERIODS <period> ...", read_period_model,
                               "Friction model in these time stepping blocks, frictionless in all others",
                               "none")
          .references(NameKind::friction_model)
          .references(NameKind::time_stepping_block)
          .required(),
  });
  return table;
}

}  // namespace

std::vector<Row<ContactDefinition>> friction_rows() {
  return {
      friction_block<Frictionless>("frictionless model", empty_table, "Normal force only"),
      friction_block<ConstantFriction>("constant friction model", constant_friction_table,
                                       "Coulomb friction"),
      friction_block<Tied>("tied model", empty_table, "What touches at the start stays together"),
      friction_block<Glued>("glued model", empty_table, "What touches once stays together from then on"),
      friction_block<SpringWeld>("spring weld model", spring_weld_table,
                                 "Springs between the sides, with a failure envelope"),
      friction_block<SurfaceWeld>("surface weld model", surface_weld_table<false>,
                                  "Tied until a force envelope is reached"),
      friction_block<SurfaceWeld>("area weld model", surface_weld_table<true>,
                                  "Tied until a traction envelope is reached", area_weld()),
      friction_block<Adhesion>("adhesion model", adhesion_table,
                               "Frictionless, with a traction across a gap"),
      friction_block<CohesiveZone>("cohesive zone model", cohesive_zone_table,
                                   "Traction by the size of normal and tangential opening"),
      friction_block<Junction>("junction model", junction_table,
                               "Traction across a gap, tangential traction by slip rate"),
      friction_block<Threaded>("threaded model", threaded_table,
                               "Springs in tension, as in a threaded joint"),
      friction_block<PressureVelocityFriction>("pv_dependent model", pressure_velocity_table,
                                               "Coefficient by pressure and slip rate"),
      friction_block<HybridFriction>("hybrid model", hybrid_table, "Model by the gap at the start"),
      friction_block<TimeVariantFriction>("time variant model", time_variant_table,
                                          "Model by time stepping block"),
      refused_block<ContactDefinition>("user subroutine model", "User subroutines cannot be run"),
  };
}

}  // namespace contactsim
