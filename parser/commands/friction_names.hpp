// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/definition/friction.hpp"
#include "parser/binding/known_names.hpp"
#include "parser/commands/region_name_uses.hpp"

namespace contactsim {

/// The friction models of a contact definition by name. FRICTIONLESS and TIED need no definition, but may
/// have one.
class FrictionNames {
 public:
  /// Two models of one name are an error at the second, or a warning when they say the same. `models` and
  /// `uses` must outlive the object.
  FrictionNames(std::span<const FrictionModel> models, const NameUses& uses);

  /// Marks a model as used; an unknown one is an error at the reference.
  void use(const DeckName& reference);

  /// Checks the models that are used, directly or by others: the names in them, that nothing they need is
  /// missing, and that a HYBRID or TIME VARIANT model does not lead back to itself.
  void check_used();

 private:
  void check(const FrictionModel& model);
  const FrictionModel* find(const DeckName& name) const;
  bool leads_to(const FrictionModel& from, const FrictionModel& target,
                std::vector<const FrictionModel*>& seen) const;

  std::span<const FrictionModel> models_;
  const NameUses& uses_;
  KnownNames names_{"friction model"};
};

}  // namespace contactsim
