// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_names.hpp"

#include "core/definition/contact.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace contactsim {

void check_surface_names(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                         Diagnostics& diagnostics) {
  std::vector<std::string> names;
  std::unordered_set<std::string> known;
  for (const ContactSurface& surface : surfaces.surfaces) {
    names.push_back(surface.name);
    known.insert(fold(surface.name));
  }
  const auto check = [&](const std::vector<DeckName>& references, std::string_view further = "") {
    for (const DeckName& reference : references) {
      const std::string name = fold(reference.text);
      if (known.contains(name) || name == further) continue;
      diagnostics.add_error(reference.location,
                            fmt::format("there is no contact surface '{}'", reference.text),
                            suggest(reference.text, names), static_cast<int>(reference.text.size()));
    }
  };
  if (contact.interaction_defaults) {
    check(contact.interaction_defaults->surfaces);
    for (const SurfaceExclusion& exclusion : contact.interaction_defaults->exclusions)
      check(exclusion.surfaces, "all");
  }
  for (const Interaction& interaction : contact.interactions) {
    check(interaction.surfaces);
    check(interaction.side_a, "all");
    check(interaction.side_b, "all");
  }
  for (const SurfaceOptions& options : contact.surface_options) {
    check(options.surfaces);
    check(options.removed_surfaces);
  }
  for (const SurfaceSmoothing& smoothing : contact.smoothings) {
    for (const SmoothingRegion& region : smoothing.regions) check(region.surfaces, "all");
  }
}

}  // namespace contactsim
