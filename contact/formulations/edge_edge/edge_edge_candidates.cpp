// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

const std::array<Eigen::Vector3d, 2> no_slip{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

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

void EdgeEdgeContacts::take_candidates(EdgePairLists candidates) {
  slips_now_ = transfer_pairs<ElasticSlips>(candidates_, slips_now_, candidates, no_slip);
  candidates_ = std::move(candidates);
}

void EdgeEdgeContacts::swap_steps() {
  std::swap(depth_before_, depth_now_);
  std::swap(slips_before_, slips_now_);
}

void EdgeEdgeContacts::begin_step() {
  swap_steps();
  std::fill(depth_now_.begin(), depth_now_.end(), 0.0f);
  slips_now_.assign(candidates_.partners.size(), no_slip);
}

void EdgeEdgeContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/edge_pairs", candidates_, saved);
  saved.rows("contact/edge_pairs/elastic_slip", slips_now_,
             [](ElasticSlips& slip, RowNumbers& row) { row(slip); });
  saved.list("contact/edges/depth", depth_now_);
}

void EdgeEdgeContacts::remap(const ContactRemap& remap) {
  std::map<std::pair<EdgeIndex, EdgeIndex>, ElasticSlips> kept;
  for (const EdgeIndex row : candidates_.rows()) {
    for (std::size_t k = candidates_.first_pair(row); k < candidates_.end_pair(row); ++k) {
      const OptionalIndex<EdgeIndex> first = remap.edges[row], second = remap.edges[candidates_.partner(k)];
      // Of edges that have changed their order the slip would be seen from the other side.
      if (first && second && *first < *second) kept[{*first, *second}] = slips_now_[k];
    }
  }
  candidates_ = {};
  slips_now_.clear();
  auto pair = kept.begin();
  for (const EdgeIndex row : indices(contact_mesh_.edges)) {
    for (; pair != kept.end() && pair->first.first == row; ++pair) {
      candidates_.partners.push_back(pair->first.second.value);
      slips_now_.push_back(pair->second);
    }
    candidates_.begin.push_back(static_cast<std::uint32_t>(candidates_.partners.size()));
  }
  edges_of_node_ = list_edges_of_nodes(contact_mesh_);
  transfer(remap.edges, remap.n_edges_after, 0.0f, depth_before_);
  transfer(remap.edges, remap.n_edges_after, 0.0f, depth_now_);
}

}  // namespace contactsim
