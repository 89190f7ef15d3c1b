// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/subcycle_refusals.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/definition/region.hpp"

namespace contactsim {

void refuse_subcycled_contact(const ConditionScope& scope, const Model& model, const ContactMesh& contact,
                              Diagnostics& diagnostics) {
  const DeckName& line = scope.region.subcycle_blocks.front();
  const auto refuse = [&](std::string text, std::string hint) {
    diagnostics.add_error(line.location, std::move(text), std::move(hint),
                          static_cast<int>(line.text.size()));
  };
  const auto& subcycled = model.subcycles.nodes;
  const auto is_subcycled = [&](NodeIndex node) { return std::ranges::binary_search(subcycled, node); };
  const auto n = std::ranges::count_if(contact.mesh_nodes, is_subcycled);
  if (n > 0) {
    const auto first = std::ranges::find_if(contact.mesh_nodes, is_subcycled);
    refuse(fmt::format("contact at nodes of subcycled elements is not supported: {} of them are of contact "
                       "surfaces, node {} for one",
                       n, scope.mesh.node_id(*first)),
           "contact acts once in a step; surfaces must be more than three layers of elements from the small "
           "ones");
  } else if (!scope.region.element_deaths.empty()) {
    refuse("contact and element death together with SUBCYCLE BLOCKS are not supported",
           "deaths may bare subcycled elements to contact");
  }
}

}  // namespace contactsim
