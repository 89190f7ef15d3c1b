// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/formulations/nodes_before_faces.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

namespace {

class NodeGaps {
 public:
  NodeGaps(const ContactKinematics& kinematics, const PairRules& rules, const ContactSearch& search)
      : contact_mesh_(kinematics.contact_mesh()), search_(search), gaps_(contact_mesh_.n_nodes(), infinite) {
    for (const PairRule& rule : rules.rules()) {
      if (!rule.is_active) continue;
      begin(rule, rule.pair->first);
      begin(rule, rule.pair->second);
    }
  }

  void take(double gap, const PairRule& rule, ContactNodeIndex node) {
    if (std::abs(gap) <= limit(rule, node) && std::abs(gap) < std::abs(gaps_[node])) gaps_[node] = gap;
  }

  IndexedVector<ContactNodeIndex, double> taken() {
    std::ranges::replace(gaps_, infinite, 0.0);
    return std::move(gaps_);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  double limit(const PairRule& rule, ContactNodeIndex node) const {
    return rule.pair->tracking_distance.value_or(search_.margin_of(node));
  }
  /// Nothing is known to be nearer than the limit.
  void begin(const PairRule& rule, SurfaceIndex surface) {
    for (const SurfaceNodeIndex row : contact_mesh_.rows_of(surface)) {
      const ContactNodeIndex node = contact_mesh_.surface_nodes[row].node;
      gaps_[node] = std::min(gaps_[node], limit(rule, node));
    }
  }

  const ContactMesh& contact_mesh_;
  const ContactSearch& search_;
  IndexedVector<ContactNodeIndex, double> gaps_;  // [n_contact_nodes] [length]
};

}  // namespace

IndexedVector<ContactNodeIndex, double> find_node_gaps(const ContactKinematics& kinematics, const Mesh& mesh,
                                                       const PairRules& rules, const DashOptions& dash,
                                                       const Motion& motion) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  ContactSearch search(contact_mesh, mesh, rules, {}, dash);
  NodeGaps gaps(kinematics, rules, search);
  visit_nodes_before_faces(search, kinematics, rules, motion, [&](const NodeBeforeFace& node) {
    gaps.take(node.gap, rules[node.pair], contact_mesh.surface_nodes[node.row].node);
  });
  return gaps.taken();
}

}  // namespace contactsim
