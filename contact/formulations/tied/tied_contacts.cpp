// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/tied_contacts.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "contact/formulations/tied/weld_failure.hpp"
#include "core/base/state_archive.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

void visit_tie(Tie& tie, RowNumbers& row) {
  visit_constraint(tie, row);
  row(tie.stiffness, tie.rest, tie.rest_energy, tie.n_points);
  for (TiePoint& point : tie.points)
    row(point.area, point.weights_1, point.weights_2, point.offset, point.force);
}

/// Whether a pair is tied or glued all along.
bool always_holds(const PairRule& rule) { return row_of(*rule.pair->law).holding != ContactLaw::sliding; }

void release(const Tie& tie, ConstrainedPairs& constrained) {
  if (tie.is_node) {
    constrained.remove_node(tie.row(), tie.pair);
  } else {
    constrained.remove_faces(tie.first_face(), tie.second);
  }
}

void hold(const Tie& tie, ConstrainedPairs& constrained) {
  if (tie.is_node) {
    constrained.add_node(tie.row(), tie.pair);
  } else {
    constrained.add_faces(tie.first_face(), tie.second);
  }
}

}  // namespace

void TiedContacts::begin_with(std::span<const Tie> ties) {
  ties_.assign(ties.begin(), ties.end());
  takes_over_ = true;
}

void TiedContacts::find_candidates(const ContactStepContext& context, const NearCandidates& near,
                                   bool only_changed, ConstrainedPairs& constrained) {
  const auto is_old = [&](const Tie& tie) {
    const PairRule& rule = context.rules[tie.pair];
    return only_changed ? rule.has_changed : !always_holds(rule);
  };
  for (const Tie& tie : ties_) {
    if (is_old(tie)) release(tie, constrained);
  }
  std::erase_if(ties_, is_old);
  const bool takes_over = takes_over_ && !only_changed;
  if (takes_over) {
    for (Tie& tie : ties_) {
      const CornerVectors x = corners_of(context, tie);
      if (context.rules[tie.pair].is_balanced) {
        replace_springs_by_points(x, tie);
      } else {
        renew_springs(tie_stiffness(context, tie), x, tie);
      }
    }
  }
  const auto ties_pair = [&](const PairRule& rule) {
    if (takes_over && always_holds(rule)) return false;
    return (!only_changed || rule.has_changed) &&
           (rule.law == ContactLaw::tied || rule.law == ContactLaw::welded);
  };
  for (const Tie& tie : make_ties(context, near.face_partners, near.node_faces, near.size_share, ties_pair)) {
    if (rule_of(context, tie).law == ContactLaw::welded) hold(tie, constrained);
    ties_.push_back(tie);
  }
}

void TiedContacts::detect(const ContactStepContext& context, std::vector<ConstraintForces>& found) const {
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    const Tie& tie = ties_[i];
    const PairRule& rule = rule_of(context, tie);
    if (!context.enforces(rule)) {
      const bool is_beside_balance = rule.is_active && !context.balances;
      if (is_beside_balance && has_constant_forces(tie))
        found.push_back({tie, find_tie_forces(tie, corners_of(context, tie)), i});
      continue;
    }
    const CornerVectors x = corners_of(context, tie);
    ConstraintForces one{tie, context.balances ? find_point_forces(tie, x) : find_tie_forces(tie, x), i};
    if (rule.law == ContactLaw::welded) {
      const WeldLaw& weld = *rule.interface_law->weld;
      one.fails = !(weld_envelope(weld, tie, one.forces) <= 1.0);
      if (one.fails) one.forces = forces_at_failure(weld, tie, one.forces);
    }
    found.push_back(one);
  }
}

void TiedContacts::update(const ContactStepContext& context, std::span<const ConstraintForces> found,
                          ConstrainedPairs& constrained, DecayingConstraints& decaying) {
  bool has_failed = false;
  for (const ConstraintForces& forces : found) {
    if (!forces.fails) continue;
    Tie& tie = ties_[forces.index];
    decaying.add(context, forces);
    release(tie, constrained);
    tie.area = 0.0;
    has_failed = true;
  }
  if (has_failed) std::erase_if(ties_, [](const Tie& tie) { return tie.area == 0.0; });
}

void TiedContacts::glue(const ContactStepContext& context, const ContactPoint& contact_point,
                        ConstrainedPairs& constrained) {
  constexpr double any_gap = std::numeric_limits<double>::infinity();
  std::optional<Tie> tie;
  if (contact_point.first.is_node()) {
    if (constrained.add_node(contact_point.row(), contact_point.pair))
      tie =
          make_node_tie(context, {contact_point.first_entity, contact_point.second_face(), contact_point.pair,
                                  true, any_gap, context.rules[contact_point.pair].pair->node_share()});
  } else if (constrained.add_faces(contact_point.first_face(), contact_point.second_face())) {
    tie = make_face_tie(context, contact_point.first_face(), contact_point.second_face(), any_gap);
  }
  if (!tie) return;
  tie->rest_energy += contact_point.stored();
  ties_.push_back(*tie);
}

void TiedContacts::archive(StateArchive& saved) { saved.rows("contact/ties", ties_, visit_tie); }

}  // namespace contactsim
