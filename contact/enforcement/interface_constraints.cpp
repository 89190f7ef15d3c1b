// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/interface_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "contact/enforcement/momentum_balance.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/formulations/tied/make_ties.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

const PairRule& rule_of(const ContactStepContext& context, const InterfaceConstraint& constraint) {
  return constraint.is_node
             ? context.rules.of_node(constraint.pair, constraint.first_entity)
             : context.rules.of_faces(constraint.pair, constraint.first_entity, constraint.second_entity);
}

TieVectors corners_of(const ContactStepContext& context, const InterfaceConstraint& constraint) {
  TieVectors x;
  for (std::size_t k = 0; k < 8; ++k)
    x.col(static_cast<Eigen::Index>(k)) = context.kinematics.x(constraint.nodes[k]);
  return x;
}

/// The work that forces do on the nodes in the step [energy].
double work_of(const ContactStepContext& context, const InterfaceConstraint& constraint,
               const TieVectors& forces) {
  double power = 0.0;
  for (std::size_t k = 0; k < 8; ++k)
    power += forces.col(static_cast<Eigen::Index>(k)).dot(context.kinematics.v(constraint.nodes[k]));
  return power * context.dt;
}

std::optional<Bond> make_bond(const ContactStepContext& context, const NearPair& near) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const ContactFace& second = contact_mesh.faces[near.second];
  const SurfacePair& pair = *context.rules[near.pair].pair;
  const MovingFace moving = context.kinematics.face(near.second);
  Bond bond;
  if (near.is_node) {
    const SurfaceNode& node = contact_mesh.surface_nodes[near.first];
    static_cast<InterfaceConstraint&>(bond) = constraint_of_node(context, near.first, near.second);
    const auto closest = find_closest_point(context, near.first, near.second, near.tolerance);
    if (!closest) return std::nullopt;
    bond.weights_1 = Eigen::Vector4d::UnitX();
    bond.weights_2 = corner_weights(closest->xi, closest->eta, moving.is_triangle);
    bond.rest = axes_of(moving.x).transpose() * (context.kinematics.x(node.node) - moving.x * bond.weights_2);
    bond.share = near.share;
    bond.area = near.share * context.kinematics.area_against(node, closest->normal);
    bond.penalty = make_pair_penalty(node.penalty_properties, &second.penalty_properties, pair).stiffness;
  } else {
    static_cast<InterfaceConstraint&>(bond) = constraint_of_faces(context, near.first, near.second);
    if (!bond_faces(context.kinematics.face(near.first), moving, near.tolerance, bond)) return std::nullopt;
    bond.penalty =
        make_pair_penalty(contact_mesh.faces[near.first].penalty_properties, &second.penalty_properties, pair)
            .stiffness;
  }
  const BondLaw& bond_law = *rule_of(context, bond).interface_law->bond_law;
  bond.size = bond_law.is_in_forces ? bond.share : bond.area;
  const double stiffness = bond_stiffness(bond_law, bond.size, bond.penalty);
  bond.springs << stiffness * bond.weights_1, stiffness * bond.weights_2;
  return bond;
}

void visit_constraint(InterfaceConstraint& constraint, RowNumbers& row) {
  row(constraint.pair, constraint.is_swapped, constraint.first_entity, constraint.second_entity,
      constraint.is_node, constraint.nodes, constraint.springs, constraint.area, constraint.share);
}

void visit_tie(Tie& tie, RowNumbers& row) {
  visit_constraint(tie, row);
  row(tie.stiffness, tie.rest, tie.rest_energy, tie.n_points);
  for (TiePoint& point : tie.points)
    row(point.area, point.weights_1, point.weights_2, point.offset, point.force);
}

void visit_bond(Bond& bond, RowNumbers& row) {
  visit_constraint(bond, row);
  BondHistory& history = bond.history;
  row(bond.weights_1, bond.weights_2, bond.rest, bond.size, bond.penalty, bond.has_failed, history.worst,
      history.worst_traction, history.tangential_energy, history.gap_factor);
}

void visit_fading(DecayingConstraint& constraint, RowNumbers& row) {
  visit_constraint(constraint, row);
  row(constraint.forces, constraint.stored, constraint.n_steps, constraint.n_done);
}

bool is_bonded(const PairRule& rule) { return rule.interface_law != nullptr && rule.interface_law->bond_law; }

/// Whether both sides of a constraint are still there; it has their new numbers then.
bool keep_constraint(const ContactRemap& remap, InterfaceConstraint& constraint) {
  constraint.first_entity = (constraint.is_node ? remap.rows : remap.faces)[constraint.first_entity];
  constraint.second_entity = remap.faces[constraint.second_entity];
  for (std::uint32_t& node : constraint.nodes) node = remap.nodes[node];
  return constraint.first_entity != ContactRemap::removed &&
         constraint.second_entity != ContactRemap::removed;
}

/// What a weld that fails passes on: of what is pressed together only the force along the surface, for the
/// rest is contact's from now on.
TieForces at_failure(const WeldLaw& weld, const InterfaceConstraint& constraint, TieForces forces) {
  forces.forces /= std::sqrt(weld_envelope(weld, constraint, forces));
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  if (forces.normal.dot(on_first) > 0.0)
    forces.forces -= (forces.normal * (forces.normal.transpose() * forces.forces)).eval();
  return forces;
}

}  // namespace

void InterfaceConstraints::add(const InterfaceConstraint& constraint, const TieForces& forces,
                               ContactAssembler& assembler) {
  assembler.add(constraint, forces);
  forces_.push_back({constraint, forces});
}

const InterfaceConstraint& InterfaceConstraints::operator[](std::size_t i) const {
  if (i < ties_.size()) return ties_[i];
  i -= ties_.size();
  if (i < bonds_.size()) return bonds_[i];
  return fading_[i - bonds_.size()];
}

void InterfaceConstraints::archive(StateArchive& saved) {
  saved.rows("contact/ties", ties_, visit_tie);
  saved.rows("contact/bonds", bonds_, visit_bond);
  saved.rows("contact/fading", fading_, visit_fading);
}

void InterfaceConstraints::begin(const ContactStepContext& context, const NearCandidates& candidates,
                                 ConstrainedPairs& constrained) {
  make(context, candidates, false, constrained);
}

void InterfaceConstraints::renew(const ContactStepContext& context, const NearCandidates& candidates,
                                 ConstrainedPairs& constrained) {
  const auto is_old = [&](const InterfaceConstraint& constraint) {
    return context.rules[constraint.pair].has_changed;
  };
  for (const Tie& tie : ties_) {
    if (is_old(tie))
      constrained.remove(tie.is_node, tie.first_entity, tie.is_node ? tie.pair : tie.second_entity);
  }
  std::erase_if(ties_, is_old);
  std::erase_if(bonds_, is_old);
  std::erase_if(fading_, is_old);
  make(context, candidates, true, constrained);
}

void InterfaceConstraints::make(const ContactStepContext& context, const NearCandidates& candidates,
                                bool only_changed, ConstrainedPairs& constrained) {
  const auto is_due = [&](const PairRule& rule) { return !only_changed || rule.has_changed; };
  const auto ties =
      make_ties(context, candidates.face_partners, candidates.node_faces, candidates.size_share,
                [&](const PairRule& rule) {
                  return is_due(rule) && (rule.law == ContactLaw::tied || rule.law == ContactLaw::welded);
                });
  for (const Tie& tie : ties) {
    if (rule_of(context, tie).law == ContactLaw::welded)
      constrained.add(tie.is_node, tie.first_entity, tie.is_node ? tie.pair : tie.second_entity);
    ties_.push_back(tie);
  }
  for (const NearPair& near :
       find_near_pairs(context, candidates.face_partners, candidates.node_faces, candidates.size_share,
                       [&](const PairRule& rule) { return is_due(rule) && is_bonded(rule); })) {
    if (auto bond = make_bond(context, near)) bonds_.push_back(*bond);
  }
}

void InterfaceConstraints::glue(const ContactStepContext& context, const ContactPoint& contact_point,
                                ConstrainedPairs& constrained) {
  constexpr double any_gap = std::numeric_limits<double>::infinity();
  std::optional<Tie> tie;
  if (contact_point.first.is_node()) {
    if (constrained.add_node(contact_point.first_entity, contact_point.pair))
      tie =
          make_node_tie(context, {contact_point.first_entity, contact_point.second_entity, contact_point.pair,
                                  true, any_gap, context.rules[contact_point.pair].pair->node_share()});
  } else if (constrained.add_faces(contact_point.first_entity, contact_point.second_entity)) {
    tie = make_face_tie(context, contact_point.first_entity, contact_point.second_entity, any_gap);
  }
  if (!tie) return;
  tie->rest_energy += contact_point.stored();
  ties_.push_back(*tie);
}

void InterfaceConstraints::remap(const ContactRemap& remap) {
  const auto remap_all = [&](auto& held) {
    std::size_t n = 0;
    for (auto& constraint : held) {
      if (keep_constraint(remap, constraint)) held[n++] = constraint;
    }
    held.resize(n);
  };
  remap_all(ties_);
  remap_all(bonds_);
  remap_all(fading_);
  std::erase_if(forces_, [&](ConstraintForces& held) { return !keep_constraint(remap, held.constraint); });
}

void InterfaceConstraints::step(const ContactStepContext& context, ConstrainedPairs& constrained,
                                ContactAssembler& assembler) {
  step_decaying(context, assembler);
  step_ties(context, constrained, assembler);
  step_bonds(context, assembler);
}

void InterfaceConstraints::step_decaying(const ContactStepContext& context, ContactAssembler& assembler) {
  if (context.dt == 0.0) return;
  for (DecayingConstraint& constraint : fading_) {
    const TieVectors x = corners_of(context, constraint);
    const TieForces before = find_decaying_forces(constraint, x);
    ++constraint.n_done;
    TieForces now = find_decaying_forces(constraint, x);
    // What the constraint held and what is done on it while it decays is lost.
    now.dissipated =
        before.stored - now.stored - work_of(context, constraint, 0.5 * (before.forces + now.forces));
    add(constraint, now, assembler);
  }
  std::erase_if(fading_, [](const DecayingConstraint& constraint) { return constraint.is_over(); });
}

void InterfaceConstraints::step_ties(const ContactStepContext& context, ConstrainedPairs& constrained,
                                     ContactAssembler& assembler) {
  take_ties(context, false, find_tie_forces, constrained, assembler);
}

void InterfaceConstraints::add_balanced(const ContactStepContext& context, MomentumBalance& balance) {
  for (Tie& tie : ties_) {
    const PairRule& rule = rule_of(context, tie);
    if (rule.is_active && rule.is_balanced) balance.add(tie);
  }
}

void InterfaceConstraints::take_balanced(const ContactStepContext& context, const MomentumBalance& balance,
                                         ConstrainedPairs& constrained, ContactAssembler& assembler) {
  const auto find_forces = [&](const Tie& tie, const TieVectors&) { return balance.find_forces(tie); };
  take_ties(context, true, find_forces, constrained, assembler);
}

template <class FindForces>
void InterfaceConstraints::take_ties(const ContactStepContext& context, bool is_balanced,
                                     const FindForces& find_forces, ConstrainedPairs& constrained,
                                     ContactAssembler& assembler) {
  bool has_failed = false;
  for (Tie& tie : ties_) {
    const PairRule& rule = rule_of(context, tie);
    if (!rule.is_active || rule.is_balanced != is_balanced) continue;
    const TieVectors x = corners_of(context, tie);
    const TieForces forces = find_forces(tie, x);
    if (rule.law != ContactLaw::welded) {
      add(tie, forces, assembler);
      continue;
    }
    const WeldLaw& weld = *rule.interface_law->weld;
    if (weld_envelope(weld, tie, forces) <= 1.0) {
      add(tie, forces, assembler);
      continue;
    }
    const TieForces last = at_failure(weld, tie, forces);
    add(tie, last, assembler);
    fading_.push_back(make_decaying(tie, last, x, rule.interface_law->decay_cycles));
    constrained.remove(tie.is_node, tie.first_entity, tie.is_node ? tie.pair : tie.second_entity);
    tie.area = 0.0;
    has_failed = true;
  }
  if (has_failed) std::erase_if(ties_, [](const Tie& tie) { return tie.area == 0.0; });
}

void InterfaceConstraints::step_bonds(const ContactStepContext& context, ContactAssembler& assembler) {
  bool has_failed = false;
  for (Bond& bond : bonds_) {
    const PairRule& rule = rule_of(context, bond);
    if (!rule.is_active) continue;
    const TieVectors x = corners_of(context, bond);
    const TieForces forces = step_bond(*rule.interface_law->bond_law, x, bond);
    add(bond, forces, assembler);
    if (!bond.has_failed) continue;
    has_failed = true;
    fading_.push_back(make_decaying(bond, forces, x, rule.interface_law->decay_cycles));
  }
  if (has_failed) std::erase_if(bonds_, [](const Bond& bond) { return bond.has_failed; });
}

}  // namespace contactsim
