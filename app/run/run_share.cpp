// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_share.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/definition/region.hpp"

namespace contactsim {

namespace {

/// The nodes that all ranks have to follow, beside those that conditions hold or load: of contact, and those
/// of elements that may die, where surfaces may come to be.
std::vector<NodeIndex> nodes_everywhere(const RunInput& input, const Setup& setup,
                                        const RunContact* contact) {
  std::vector<NodeIndex> nodes;
  for (const auto& set : setup.death_sets) {
    for (const ElementIndex element : set)
      std::ranges::copy(input.mesh.element_nodes(element), std::back_inserter(nodes));
  }
  setup.external.add_nodes_where_place_counts(nodes);
  const auto& subcycled = setup.model.subcycles.nodes;
  nodes.insert(nodes.end(), subcycled.begin(), subcycled.end());
  if (contact == nullptr) return nodes;
  const auto& of_contact = contact->force().contact_mesh().mesh_nodes;
  nodes.insert(nodes.end(), of_contact.begin(), of_contact.end());
  return nodes;
}

/// A trial of few elements takes no longer than its messages, of which there are thousands in a load step:
/// blocks of 3,456 hexahedra took as long on two ranks as on one.
bool are_load_steps_shared(Ranks& ranks, const RunInput& input) {
  constexpr std::size_t least_elements_a_rank = 1536;
  const SolverSettings solver = input.region.solver.value_or(SolverSettings{});
  return (solver.cg.full_tangent && solver.cg.full_tangent->linear_solver == LinearSolver::distributed) ||
         input.mesh.n_elements() >= least_elements_a_rank * static_cast<std::size_t>(ranks.count());
}

}  // namespace

std::unique_ptr<RankShare> make_share(Ranks& ranks, const RunInput& input, const Setup& setup,
                                      const RunContact* contact) {
  if (!ranks.are_several()) return nullptr;
  if (setup.load_schedule) {
    if (!are_load_steps_shared(ranks, input)) return nullptr;
    return std::make_unique<RankShare>(ranks, setup.model, std::span<const NodeIndex>());
  }
  return std::make_unique<RankShare>(ranks, setup.model, nodes_everywhere(input, setup, contact));
}

std::unique_ptr<SharedElements> make_shared_elements(const Setup& setup, ForceTerm& internal,
                                                     RankShare* share) {
  if (share == nullptr || !setup.load_schedule) return nullptr;
  return std::make_unique<SharedElements>(internal, *share);
}

}  // namespace contactsim
