// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/output/element_view.hpp"

namespace contactsim {

/// Means over the pairs of nodes of a cohesive element; zeros of any other element.
struct CohesiveValues {
  std::array<double, 2> separation{};  ///< opening, negative in compression, and sliding [length]
  std::array<double, 2> traction{};    ///< against them [force/length^2]
  double damage = 0.0;                 ///< share of the stiffness that is lost, 1 when all has failed [1]
  double dissipation = 0.0;            ///< of the element: work that it does not give back [energy]

  explicit CohesiveValues(const ElementView& element);
};

}  // namespace contactsim
