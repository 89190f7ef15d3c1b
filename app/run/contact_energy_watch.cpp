// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/contact_energy_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/run/energy_watch.hpp"
#include "app/run/start_overlap.hpp"
#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// Energy that contact makes is worth a warning when it is this share of the largest term.
constexpr double worrying_energy_share = 0.01;

/// Energy from nowhere that exceeds what was put in for so many steps will not go away.
constexpr int longest_runaway = 20;

/// What contact has given out that nothing had put into it [energy].
double made_by_contact(const ContactForce& force, const Energies& energies) {
  const double stored = force.stored() - force.stored_at_start();
  return stored + energies.friction + energies.contact_damping + energies.stabilization +
         std::max(energies.impact, 0.0) - energies.contact;
}

/// The pair that has made the most energy; the first without any pairs.
PairIndex find_culprit(IndexedSpan<PairIndex, const PairHistory> histories) {
  const auto most = std::ranges::max_element(histories, {}, &PairHistory::made);
  return index_of(histories, most);
}

}  // namespace

double given_out_by_overlaps(const ContactForce& force, bool begins_pressed) {
  double sum = 0.0;
  const auto histories = force.histories();
  for (const PairIndex i : indices(histories)) {
    if (!force.rules()[i].is_balanced) continue;
    const double made = std::max(0.0, histories[i].made());
    sum += begins_pressed ? made : std::min(made, force.recovery_energy().of_overlaps(i));
  }
  return sum;
}

void ContactEnergyWatch::step(const ContactForce& force, double of_overlaps, const ContactModel& contact,
                              const Model& model, const State& state) {
  const Energies& e = state.energies;
  const double made = made_by_contact(force, e) - of_overlaps;
  if (made > most_) {
    most_ = made;
    culprit_ = find_culprit(force.histories());
    by_culprit_ = force.histories()[culprit_].made();
  }
  const double put_in = std::max(0.0, e.start) + std::max(0.0, e.external) + std::max(0.0, -e.internal) +
                        force.stored_at_start();
  // What comes out of overlaps by itself is not worth a word: all of the mass at a millionth of the model's
  // size in a step.
  constexpr double of_round_off = 1e-6 / std::numeric_limits<double>::epsilon();
  const auto is_negligible = [&] {
    return made <= of_round_off * of_round_off * energy_of_round_off(model, state.dt);
  };
  const bool runs_away = made > put_in && !is_negligible();
  n_runaway_steps_ = runs_away ? n_runaway_steps_ + 1 : 0;
  if (n_runaway_steps_ < longest_runaway || contact.pairs.empty()) return;
  const PairIndex culprit = find_culprit(force.histories());
  throw SolveError(
      state.time, fmt::format("contact between {} runs away: it has given out {:.3g} of energy from nowhere, "
                              "and all contact {:.3g}, more than all that was put into the model, {:.3g}",
                              names_of(contact, culprit), force.histories()[culprit].made(), made, put_in));
}

void ContactEnergyWatch::warn(const ContactModel& contact, const Energies& energies,
                              Diagnostics& warnings) const {
  if (most_ <= worrying_energy_share * energies.largest) return;
  warnings.add_warning(
      "contact-energy", contact.pairs[culprit_].location,
      fmt::format("contact has given out up to {:.3g} of energy that nothing put in ({:.2g} % of the "
                  "largest term), most of it between {}: {:.3g}",
                  most_, 100.0 * most_ / energies.largest, names_of(contact, culprit_), by_culprit_),
      "finer faces where corners meet, NODE_FACE or a CONTACT DAMPING FRACTION help");
}

void ContactEnergyWatch::archive(StateArchive& saved) {
  saved.numbers("contact/made", most_, by_culprit_, culprit_.value);
}

}  // namespace contactsim
