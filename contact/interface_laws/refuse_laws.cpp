// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/refuse_laws.hpp"

#include <fmt/format.h>

#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// Whether a model, or one that it may be, holds its sides together.
bool holds(const PairInterfaceLaw& law) {
  bool found = false;
  const auto visit = [&](const std::shared_ptr<const InterfaceLaw>& one) { found |= one && one->holds(); };
  visit(law.law);
  visit(law.far);
  for (const PairInterfaceLaw::Period& period : law.periods) visit(period.law);
  return found;
}

}  // namespace

void refuse_laws(const SurfacePairs& pairs, const SurfaceList& surfaces, const LawScope& scope,
                 Diagnostics& diagnostics) {
  const auto laws = make_pair_laws(pairs, scope, diagnostics);
  for (const PairIndex i : indices(pairs)) {
    const SurfacePair& pair = pairs[i];
    const ContactSurface &first = surfaces[pair.first], &second = surfaces[pair.second];
    if (first.analytic_planes.empty() && second.analytic_planes.empty()) continue;
    if (!holds(laws[i])) continue;
    diagnostics.add_error(pair.location,
                          fmt::format("'{}' and '{}' cannot be {}: one is an analytic plane", first.name,
                                      second.name, describe_law(*pair.law)),
                          "nothing is held to planes");
  }
}

}  // namespace contactsim
