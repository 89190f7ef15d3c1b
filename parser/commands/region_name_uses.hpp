// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/condition_lines.hpp"
#include "core/definition/entity_set.hpp"
#include "core/definition/output_schedule.hpp"
#include "parser/commands/region_names.hpp"

namespace contactsim {

/// Looks up the names in the lines that many blocks share. `outside` and `diagnostics` must outlive the
/// object.
class NameUses {
 public:
  NameUses(OutsideNames& outside, Diagnostics& diagnostics) : outside_(outside), diagnostics_(diagnostics) {}

  OutsideNames& outside() const { return outside_; }
  Diagnostics& diagnostics() const { return diagnostics_; }

  void use(const EntitySet& set) const;
  void use(const DirectionChoice& choice) const;
  void use(const ScaledFunction& function) const;
  void use(const OutputSchedule& schedule) const;
  /// Both lists at once are an error at the second.
  void use(const ActivePeriods& periods) const;
  void use_periods(const std::vector<DeckName>& periods) const;

  /// An error under a name: of the block's name, or of BEGIN when it has none.
  void add_error(const DeckName& at, std::string text, std::string hint = "") const;

 private:
  OutsideNames& outside_;
  Diagnostics& diagnostics_;
};

}  // namespace contactsim
