// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// What of a pair that is held at the start is too far apart for it.
struct UntiedPart {
  SurfaceIndex surface;          ///< the smaller one, of one-sided pairs that with the nodes
  double tied = 0.0;             ///< area of it that is held [length^2]
  double untied = 0.0;           ///< area of it before the other side that is not [length^2]
  double widest_gap = 0.0;       ///< of that, either way [length]
  std::vector<NodeIndex> nodes;  ///< its nodes before the other side that nothing holds, ascending

  bool is_partial() const {
    constexpr double negligible = 1e-3;
    return tied > 0.0 && untied > negligible * (tied + untied);
  }
};

using UntiedParts = IndexedVector<PairIndex, UntiedPart>;

/// Looks at the pairs whose law holds what is near at the start, on a mesh as it is: how much of the smaller
/// surface is held, and how much lies before the other side, by twice its tolerance or two mean edges of the
/// faces at most, without being held. What is farther is not thought to be part of the joint.
UntiedParts find_untied_parts(const ContactModel& model, const Mesh& mesh, const DashOptions& dash);

}  // namespace contactsim
