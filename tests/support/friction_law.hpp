// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim::test {

/// A law of the table as a deck would give it: its name, and values by their phrases.
inline FrictionLaw friction_law(const std::string& name,
                                std::initializer_list<std::pair<const char*, ParameterValue>> given = {}) {
  FrictionLaw law = make_friction_law(name);
  for (const auto& [phrase, value] : given) law.values.set(phrase, value);
  return law;
}

inline FrictionLaw coulomb(double coefficient) {
  return friction_law("constant friction", {{"friction coefficient", coefficient}});
}

/// The same as pairs hold it.
inline std::shared_ptr<const FrictionLaw> share(FrictionLaw law) {
  return std::make_shared<const FrictionLaw>(std::move(law));
}

}  // namespace contactsim::test
