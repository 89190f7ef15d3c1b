// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_name_uses.hpp"

#include <algorithm>

namespace contactsim {

void NameUses::use(const EntitySet& set) const {
  for (const DeckName& body : set.rigid_bodies) outside_.rigid_bodies.use(body, diagnostics_);
}

void NameUses::use(const DirectionChoice& choice) const {
  if (choice.direction) outside_.directions.use(*choice.direction, diagnostics_);
  if (choice.cylindrical_axis) outside_.axes.use(*choice.cylindrical_axis, diagnostics_);
}

void NameUses::use(const ScaledFunction& function) const {
  if (function.function) outside_.functions.use(*function.function, diagnostics_);
}

void NameUses::use(const OutputSchedule& schedule) const {
  if (schedule.scheduler) outside_.output_schedulers.use(*schedule.scheduler, diagnostics_);
}

void NameUses::use_periods(const std::vector<DeckName>& periods) const {
  for (const DeckName& period : periods) outside_.periods.use(period, diagnostics_);
}

void NameUses::use(const ActivePeriods& periods) const {
  use_periods(periods.active);
  use_periods(periods.inactive);
  if (!periods.active.empty() && !periods.inactive.empty()) {
    add_error(periods.inactive.front(), "ACTIVE PERIODS and INACTIVE PERIODS in one block",
              "the active ones stand at " + to_string(periods.active.front().location));
  }
}

void NameUses::add_error(const DeckName& at, std::string text, std::string hint) const {
  const int length = std::max(1, static_cast<int>(at.text.size()));
  diagnostics_.add_error(at.location, std::move(text), std::move(hint), length);
}

}  // namespace contactsim
