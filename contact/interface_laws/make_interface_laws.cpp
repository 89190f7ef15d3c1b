// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/make_interface_laws.hpp"

#include <fmt/format.h>

#include <map>

namespace contactsim {

namespace {

bool slides(const FrictionLaw& law) {
  return std::holds_alternative<Frictionless>(law) || std::holds_alternative<ConstantFriction>(law) ||
         std::holds_alternative<PressureVelocityFriction>(law) || std::holds_alternative<Adhesion>(law) ||
         std::holds_alternative<Junction>(law);
}

/// Makes an interface law from a friction model. The visitor's result is null when an error was added.
class InterfaceLawMaker {
 public:
  using Made = std::shared_ptr<const InterfaceLaw>;

  InterfaceLawMaker(const LawScope& scope, const DeckLocation& user, Diagnostics& diagnostics)
      : scope_(scope), user_(user), diagnostics_(diagnostics) {}

  Made operator()(const Frictionless&) { return share({}); }
  Made operator()(const ConstantFriction& law) {
    InterfaceLaw made;
    made.friction = law.coefficient;
    return share(made);
  }
  Made operator()(const Tied&) { return share(with(ContactLaw::tied)); }
  Made operator()(const Glued&) { return share(with(ContactLaw::glued)); }
  Made operator()(const PressureVelocityFriction& law) {
    InterfaceLaw made;
    made.friction = 1.0;
    made.pressure_velocity = law;
    return share(made);
  }
  Made operator()(const Adhesion& law) {
    InterfaceLaw made;
    made.pull = curve(law.adhesion);
    return made.pull ? share(std::move(made)) : nullptr;
  }
  Made operator()(const Junction& law);
  Made operator()(const SpringWeld& law);
  Made operator()(const SurfaceWeld& law);
  Made operator()(const CohesiveZone& law);
  Made operator()(const Threaded& law);
  Made operator()(const HybridFriction&) { return refuse_selection(); }
  Made operator()(const TimeVariantFriction&) { return refuse_selection(); }

  /// The law of a model by name; frictionless without one.
  Made named(const std::optional<DeckName>& name);

 private:
  static Made share(InterfaceLaw law) { return std::make_shared<const InterfaceLaw>(std::move(law)); }
  static InterfaceLaw with(ContactLaw law) {
    InterfaceLaw made;
    made.law = law;
    return made;
  }
  std::optional<LawCurve> curve(const ScaledFunction& named) {
    return make_law_curve(named, scope_.functions, diagnostics_);
  }
  std::optional<Function> function(const ScaledFunction& named) {
    return make_named_function(named.function.value(), scope_.functions, diagnostics_);
  }
  Made refuse_selection() {
    diagnostics_.add_error(user_, "a HYBRID or TIME VARIANT model cannot select another such model in a run",
                           "name the models that it selects");
    return nullptr;
  }
  /// The law after failure, with what holds until then.
  Made with_failure(BondLaw bond_law, const WeldFailure& failure);

  const LawScope& scope_;
  const DeckLocation& user_;
  Diagnostics& diagnostics_;
};

InterfaceLawMaker::Made InterfaceLawMaker::named(const std::optional<DeckName>& name) {
  if (!name) return share({});
  const FrictionLaw* law = find_friction_law(scope_.models, name->text);
  return law != nullptr ? std::visit(*this, *law) : nullptr;
}

InterfaceLawMaker::Made InterfaceLawMaker::operator()(const Junction& law) {
  InterfaceLaw made;
  made.pull = curve(law.normal);
  auto traction = function(law.tangential);
  if (!made.pull || !traction) return nullptr;
  made.rate_limit = {*traction, law.tangential.scale_factor,
                     law.tangential_cutoff.value_or(made.pull->last())};
  return share(std::move(made));
}

InterfaceLawMaker::Made InterfaceLawMaker::operator()(const SpringWeld& law) {
  auto normal = curve(law.normal), tangential = curve(law.tangential);
  if (!normal || !tangential) return nullptr;
  return with_failure(SpringWeldLaw{*normal, *tangential, law.envelope_exponent}, law.failure);
}

InterfaceLawMaker::Made InterfaceLawMaker::operator()(const SurfaceWeld& law) {
  return with_failure(WeldLaw{law.is_per_area, law.normal_capacity, law.tangential_capacity}, law.failure);
}

InterfaceLawMaker::Made InterfaceLawMaker::operator()(const CohesiveZone& law) {
  auto traction = curve(law.traction);
  if (!traction) return nullptr;
  if (!traction->softens()) {
    diagnostics_.add_error(
        law.traction.function->location,
        fmt::format(
            "the traction '{}' of a cohesive zone must not rise faster than its abscissa, or be negative",
            law.traction.function->text),
        "unloading to the origin would make energy");
    return nullptr;
  }
  return with_failure(CohesiveLaw{*traction, law.critical_normal_gap, law.critical_tangential_gap}, {});
}

InterfaceLawMaker::Made InterfaceLawMaker::operator()(const Threaded& law) {
  auto normal = curve(law.normal), tangential = curve(law.tangential);
  std::optional<Function> by_gap;
  if (law.tangential_gap.function) by_gap = function(law.tangential_gap);
  if (!normal || !tangential || (law.tangential_gap.function && !by_gap)) return nullptr;
  return with_failure(ThreadedJointLaw{*normal, *tangential, by_gap, law.tangential_gap.scale_factor,
                                       law.normal_capacity, law.tangential_capacity, law.envelope_exponent},
                      law.failure);
}

InterfaceLawMaker::Made InterfaceLawMaker::with_failure(BondLaw bond_law, const WeldFailure& failure) {
  const FrictionLaw* failed =
      failure.failed_model ? find_friction_law(scope_.models, failure.failed_model->text) : nullptr;
  if (failed != nullptr && !slides(*failed)) {  // checked first: models may name each other in a ring
    diagnostics_.add_error(
        failure.failed_model->location,
        fmt::format("the FAILED MODEL '{}' holds what has just failed", failure.failed_model->text),
        "it must slide: frictionless, constant friction, pv_dependent, adhesion or junction");
    return nullptr;
  }
  const Made after = named(failure.failed_model);
  if (!after) return nullptr;
  InterfaceLaw made = *after;
  made.bond_law = std::move(bond_law);
  if (made.is_weld()) made.law = ContactLaw::welded;
  made.decay_cycles = failure.decay_cycles;
  return share(std::move(made));
}

PairInterfaceLaw make_pair_law(const FrictionLaw& law, const LawScope& scope, InterfaceLawMaker& maker) {
  PairInterfaceLaw made;
  if (const auto* hybrid = std::get_if<HybridFriction>(&law)) {
    made.law = maker.named(hybrid->initially_close);
    made.far = maker.named(hybrid->initially_far);
  } else if (const auto* variant = std::get_if<TimeVariantFriction>(&law)) {
    for (const PeriodModel& model : variant->models) {
      const ActivePeriods periods{model.periods, {}};
      made.periods.push_back(
          {make_active_times(periods, scope.time_stepping_blocks), maker.named(model.model)});
    }
    made.law = maker.named(std::nullopt);
  } else {
    made.law = std::visit(maker, law);
  }
  return made;
}

}  // namespace

std::vector<PairInterfaceLaw> make_pair_laws(std::span<const SurfacePair> pairs, const LawScope& scope,
                                             Diagnostics& diagnostics) {
  std::map<std::string, PairInterfaceLaw> known;  // of the interactions, which give all their pairs one law
  std::vector<PairInterfaceLaw> laws;
  for (const SurfacePair& pair : pairs) {
    const auto [place, is_new] = known.try_emplace(to_string(pair.location) + pair.interaction);
    if (is_new) {
      InterfaceLawMaker maker(scope, pair.location, diagnostics);
      place->second = make_pair_law(*pair.law, scope, maker);
    }
    laws.push_back(place->second);
  }
  return laws;
}

}  // namespace contactsim
