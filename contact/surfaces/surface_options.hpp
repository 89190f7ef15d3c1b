// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "core/base/names.hpp"
#include "core/definition/contact_options.hpp"

namespace contactsim {

/// Calls visit(surface, options) for every block of SURFACE OPTIONS and each surface that it is for,
/// in deck order: a later one overrides what earlier ones give.
template <class Visit>
void visit_surface_options(const std::vector<SurfaceOptions>& blocks, const SurfaceList& surfaces,
                           const Visit& visit) {
  const auto fold_all = [](const std::vector<DeckName>& names) {
    std::set<std::string> folded;
    for (const DeckName& name : names) folded.insert(fold(name.text));
    return folded;
  };
  for (const SurfaceOptions& options : blocks) {
    const auto included = fold_all(options.surfaces), removed = fold_all(options.removed_surfaces);
    for (const SurfaceIndex i : indices(surfaces)) {
      const std::string name = fold(surfaces[i].name);
      const bool is_included = included.empty() || included.contains(name);
      if (is_included && !removed.contains(name)) visit(i, options);
    }
  }
}

}  // namespace contactsim
