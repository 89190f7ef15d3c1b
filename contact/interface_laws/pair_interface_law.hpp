// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/conditions/active_times.hpp"
#include "core/interface_laws/interface_law.hpp"

namespace contactsim {

/// The friction model of a pair: one, one by whether the sides were close at the start, or one by period.
struct PairInterfaceLaw {
  struct Period {
    ActiveTimes times;
    std::shared_ptr<const InterfaceLaw> law;
  };
  std::shared_ptr<const InterfaceLaw> law;  ///< HYBRID: where the sides were close at the start
  std::shared_ptr<const InterfaceLaw> far;  ///< HYBRID: elsewhere; else null
  std::vector<Period> periods;              ///< TIME VARIANT; frictionless in none of them

  bool is_variant() const { return !periods.empty(); }
  /// Calls a function with every model that the pair may have.
  template <class Visit>
  void visit_models(const Visit& visit) const {
    if (law) visit(*law);
    if (far) visit(*far);
    for (const Period& period : periods) visit(*period.law);
  }
};

}  // namespace contactsim
