// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/bonded/bonded_contacts.hpp"

#include <optional>

#include "contact/formulations/penalty.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

std::optional<Bond> make_bond(const ContactStepContext& context, const NearPair& near) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const ContactFace& second = contact_mesh.faces[near.second];
  const SurfacePair& pair = *context.rules[near.pair].pair;
  const MovingFace moving = context.kinematics.face(near.second);
  Bond bond;
  if (near.is_node) {
    const SurfaceNode& node = contact_mesh.surface_nodes[near.row()];
    static_cast<InterfaceConstraint&>(bond) = constraint_of_node(context, near.row(), near.second);
    const auto closest = find_closest_point(context, near.row(), near.second, near.tolerance);
    if (!closest) return std::nullopt;
    bond.weights_1 = Eigen::Vector4d::UnitX();
    bond.weights_2 = corner_weights(closest->xi, closest->eta, moving.is_triangle);
    bond.rest = axes_of(moving.x).transpose() * (context.kinematics.x(node.node) - moving.x * bond.weights_2);
    bond.share = near.share;
    bond.area = near.share * context.kinematics.area_against(node, closest->normal);
    bond.penalty = make_pair_penalty(node.penalty_properties, &second.penalty_properties, pair).stiffness;
  } else {
    static_cast<InterfaceConstraint&>(bond) = constraint_of_faces(context, near.first_face(), near.second);
    const MovingFace first = context.kinematics.face(near.first_face());
    const auto overlap = find_mean_overlap(first, moving, near.tolerance);
    if (!overlap) return std::nullopt;
    bond.weights_1 = overlap->weights_1;
    bond.weights_2 = overlap->weights_2;
    bond.area = overlap->area;
    bond.rest = axes_of(moving.x).transpose() * (first.x * bond.weights_1 - moving.x * bond.weights_2);
    bond.penalty = make_pair_penalty(contact_mesh.faces[near.first_face()].penalty_properties,
                                     &second.penalty_properties, pair)
                       .stiffness;
  }
  const BondLaw& bond_law = *rule_of(context, bond).interface_law->bond_law;
  bond.size = bond_law.is_in_forces ? bond.share : bond.area;
  const double stiffness = bond_stiffness(bond_law, bond.size, bond.penalty);
  bond.springs << stiffness * bond.weights_1, stiffness * bond.weights_2;
  return bond;
}

void visit_bond(Bond& bond, RowNumbers& row) {
  visit_constraint(bond, row);
  BondHistory& history = bond.history;
  row(bond.weights_1, bond.weights_2, bond.rest, bond.size, bond.penalty, bond.has_failed, history.worst,
      history.worst_traction, history.tangential_energy, history.gap_factor);
}

bool is_bonded(const PairRule& rule) { return rule.interface_law != nullptr && rule.interface_law->bond_law; }

}  // namespace

void BondedContacts::find_candidates(const ContactStepContext& context, const NearCandidates& near,
                                     bool only_changed, ConstrainedPairs& /*constrained*/) {
  if (only_changed)
    std::erase_if(bonds_, [&](const Bond& bond) { return context.rules[bond.pair].has_changed; });
  const auto bonds_pair = [&](const PairRule& rule) {
    return (!only_changed || rule.has_changed) && is_bonded(rule);
  };
  for (const NearPair& near_pair :
       find_near_pairs(context, near.face_partners, near.node_faces, near.size_share, bonds_pair)) {
    if (auto bond = make_bond(context, near_pair)) bonds_.push_back(*bond);
  }
}

void BondedContacts::detect(const ContactStepContext& context, std::vector<ConstraintForces>& found) const {
  if (context.balances) return;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const PairRule& rule = rule_of(context, bond);
    if (!rule.is_active) continue;
    const BondStep step = find_bond_step(*rule.interface_law->bond_law, corners_of(context, bond), bond);
    found.push_back({bond, step.forces, i, step.fails, step.history});
  }
}

void BondedContacts::update(const ContactStepContext& context, std::span<const ConstraintForces> found,
                            ConstrainedPairs& /*constrained*/, DecayingConstraints& decaying) {
  bool has_failed = false;
  for (const ConstraintForces& forces : found) {
    Bond& bond = bonds_[forces.index];
    bond.history = forces.history;
    bond.has_failed = forces.fails;
    if (!forces.fails) continue;
    has_failed = true;
    decaying.add(context, forces);
  }
  if (has_failed) std::erase_if(bonds_, [](const Bond& bond) { return bond.has_failed; });
}

void BondedContacts::archive(StateArchive& saved) { saved.rows("contact/bonds", bonds_, visit_bond); }

}  // namespace contactsim
