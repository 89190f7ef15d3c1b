// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/make_interface_laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

std::string list_sliding() {
  std::vector<std::string_view> names;
  for (const InterfaceLawRow& row : interface_law_rows()) {
    if (row.slides()) names.push_back(row.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Makes interface laws from friction models. Results are null when an error was added.
class InterfaceLawMaker {
 public:
  using Made = std::shared_ptr<const InterfaceLaw>;

  InterfaceLawMaker(const LawScope& scope, const DeckLocation& user, Diagnostics& diagnostics)
      : scope_(scope), user_(user), diagnostics_(diagnostics) {}

  Made operator()(const FrictionLaw& law) const;
  /// The law of a model by name; frictionless without one.
  Made named(const std::optional<DeckName>& name) const;

 private:
  bool fails_into_holding(const FrictionLaw& law) const;

  const LawScope& scope_;
  const DeckLocation& user_;
  Diagnostics& diagnostics_;
};

InterfaceLawMaker::Made InterfaceLawMaker::named(const std::optional<DeckName>& name) const {
  if (!name) return std::make_shared<const InterfaceLaw>();
  const FrictionLaw* law = find_friction_law(scope_.models, name->text);
  return law != nullptr ? (*this)(*law) : nullptr;
}

InterfaceLawMaker::Made InterfaceLawMaker::operator()(const FrictionLaw& law) const {
  const InterfaceLawRow& row = row_of(law);
  if (row.select != nullptr) {
    diagnostics_.add_error(user_, "a HYBRID or TIME VARIANT model cannot select another such model in a run",
                           "name the models that it selects");
    return nullptr;
  }
  InterfaceLaw made;
  made.law = row.holding;
  if (row.make == nullptr) return std::make_shared<const InterfaceLaw>(std::move(made));
  auto own = row.make({law.values, scope_.functions, diagnostics_});
  if (!own) return nullptr;
  if (!law.values.knows("failed model")) return std::make_shared<const InterfaceLaw>(std::move(*own));
  if (fails_into_holding(law)) return nullptr;
  // What follows the failure acts beside what holds, so that it is there at once.
  const Made after = named(law.values.find_name("failed model"));
  if (!after) return nullptr;
  made = *after;
  made.law = own->law;
  made.bond_law = std::move(own->bond_law);
  made.weld = own->weld;
  made.decay_cycles = law.values.count("failure decay cycles");
  return std::make_shared<const InterfaceLaw>(std::move(made));
}

/// Adds an error for a FAILED MODEL that does not slide. Checked before it is made: models may name each
/// other in a ring.
bool InterfaceLawMaker::fails_into_holding(const FrictionLaw& law) const {
  const auto name = law.values.find_name("failed model");
  const FrictionLaw* failed = name ? find_friction_law(scope_.models, name->text) : nullptr;
  if (failed == nullptr || row_of(*failed).slides()) return false;
  diagnostics_.add_error(name->location,
                         fmt::format("the FAILED MODEL '{}' holds what has just failed", name->text),
                         "it must slide: " + list_sliding());
  return true;
}

PairInterfaceLaw make_pair_law(const FrictionLaw& law, const LawScope& scope,
                               const InterfaceLawMaker& maker) {
  PairInterfaceLaw made;
  const InterfaceLawRow& row = row_of(law);
  if (row.select == nullptr) {
    made.law = maker(law);
    return made;
  }
  const LawSelection selection = row.select(law.values);
  made.law = maker.named(selection.close);
  if (selection.by_period.empty()) made.far = maker.named(selection.far);
  for (const PeriodModel& model : selection.by_period) {
    const ActivePeriods periods{model.periods, {}};
    made.periods.push_back(
        {make_active_times(periods, scope.time_stepping_blocks), maker.named(model.model)});
  }
  return made;
}

}  // namespace

IndexedVector<PairIndex, PairInterfaceLaw> make_pair_laws(std::span<const SurfacePair> pairs,
                                                          const LawScope& scope, Diagnostics& diagnostics) {
  std::map<std::string, PairInterfaceLaw> known;  // of the interactions, which give all their pairs one law
  IndexedVector<PairIndex, PairInterfaceLaw> laws;
  for (const SurfacePair& pair : pairs) {
    const auto [place, is_new] = known.try_emplace(to_string(pair.location) + pair.interaction);
    if (is_new) {
      const InterfaceLawMaker maker(scope, pair.location, diagnostics);
      place->second = make_pair_law(*pair.law, scope, maker);
    }
    laws.push_back(place->second);
  }
  return laws;
}

}  // namespace contactsim
