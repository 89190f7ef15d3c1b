// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <utility>

#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// Lines and sharp edges by first_alike of their nodes; nothing without any edges.
PairLists<ContactNodeIndex, EdgeIndex> list_edges_of_nodes(const ContactMesh& contact_mesh) {
  if (contact_mesh.edges.empty()) return {};
  return list_by_row<ContactNodeIndex, EdgeIndex>(contact_mesh.n_nodes(), [&](const auto& take) {
    for (const EdgeIndex i : indices(contact_mesh.edges)) {
      const ContactEdge& edge = contact_mesh.edges[i];
      if (edge.is_particle()) continue;
      for (const ContactNodeIndex node : edge.nodes) take(contact_mesh.first_alike[node], i);
    }
  });
}

}  // namespace

EdgeEdgeContacts::EdgeEdgeContacts(const FormulationSetup& setup)
    : contact_mesh_(setup.contact_mesh),
      edges_of_node_(list_edges_of_nodes(contact_mesh_)),
      depth_before_(contact_mesh_.edges.size(), 0.0f),
      depth_now_(contact_mesh_.edges.size(), 0.0f) {}

void EdgeEdgeContacts::find_candidates(ContactSearch& search, const ContactKinematics& kinematics,
                                       const Motion& motion) {
  if (contact_mesh_.edges.empty()) return;
  EdgePairLists next;
  search.find_edge_pairs(kinematics, motion, depth_now_, next);
  take_candidates(std::move(next));
}

void EdgeEdgeContacts::begin_detection(const ContactStepContext& context) {
  if (context.candidates == CandidateUse::close)
    return bounds_.update(context.kinematics, close_edges_, depth_before_);
  const IndexRange<EdgeIndex> all = indices(contact_mesh_.edges);
  if (all_edges_.size() != contact_mesh_.edges.size()) all_edges_.assign(all.begin(), all.end());
  bounds_.update(context.kinematics, all_edges_, depth_before_);
  if (context.candidates != CandidateUse::renew_close) return;
  close_.renew_pairs<EdgeBounds::Pairs>(
      candidates_, [&](const auto& pairs) { return bounds_.may_cross(pairs, context.close_range.motion); });
  IndexedVector<EdgeIndex, std::uint8_t> is_close(contact_mesh_.edges.size(), 0);
  close_.visit_close([&](EdgeIndex first, std::size_t position) {
    is_close[first] = is_close[candidates_.partner(position)] = 1;
  });
  close_edges_.clear();
  std::ranges::copy_if(all_edges_, std::back_inserter(close_edges_),
                       [&](EdgeIndex edge) { return is_close[edge] != 0; });
}

void EdgeEdgeContacts::swap_steps() {
  std::swap(depth_before_, depth_now_);
  std::swap(slips_before_, slips_now_);
}

void EdgeEdgeContacts::begin_step() {
  swap_steps();
  std::fill(depth_now_.begin(), depth_now_.end(), 0.0f);
  slips_now_.clear();
}

void EdgeEdgeContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/edge_pairs", candidates_, saved);
  close_.forget();
  slips_now_.archive(saved);
  saved.list("contact/edges/depth", depth_now_);
}

void EdgeEdgeContacts::remap(const ContactRemap& remap) {
  std::vector<std::pair<EdgeIndex, EdgeIndex>> kept;
  for (const EdgeIndex row : candidates_.rows()) {
    for (const EdgeIndex partner : candidates_.of(row)) {
      const OptionalIndex<EdgeIndex> first = remap.edges[row], second = remap.edges[partner];
      if (first && second && *first < *second) kept.emplace_back(*first, *second);
    }
  }
  std::ranges::sort(kept);
  candidates_ = list_by_row<EdgeIndex, EdgeIndex>(contact_mesh_.edges.size(), [&](const auto& take) {
    for (const auto& [first, second] : kept) take(first, second);
  });
  close_.forget();
  slips_now_.remap(remap);
  edges_of_node_ = list_edges_of_nodes(contact_mesh_);
  transfer(remap.edges, remap.n_edges_after, 0.0f, depth_before_);
  transfer(remap.edges, remap.n_edges_after, 0.0f, depth_now_);
}

}  // namespace contactsim
