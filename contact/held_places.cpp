// SPDX-License-Identifier: BSD-3-Clause
#include "contact/held_places.hpp"

#include <algorithm>
#include <cmath>

#include "contact/enforcement/momentum_balance.hpp"
#include "contact/make_ties.hpp"
#include "contact/penalty.hpp"
#include "core/state_archive.hpp"

namespace contactsim {

namespace {

const PairRule& rule_of(const ContactScene& scene, const HeldPlace& place) {
  return place.is_node ? scene.rules.of_node(place.pair, place.first_place)
                       : scene.rules.of_faces(place.pair, place.first_place, place.second_place);
}

TieVectors corners_of(const ContactScene& scene, const HeldPlace& place) {
  TieVectors x;
  for (std::size_t k = 0; k < 8; ++k) x.col(static_cast<Eigen::Index>(k)) = scene.surface.x(place.nodes[k]);
  return x;
}

/// The work that forces do on the nodes in the step [energy].
double work_of(const ContactScene& scene, const HeldPlace& place, const TieVectors& forces) {
  double power = 0.0;
  for (std::size_t k = 0; k < 8; ++k)
    power += forces.col(static_cast<Eigen::Index>(k)).dot(scene.surface.v(place.nodes[k]));
  return power * scene.dt;
}

std::optional<Bond> make_bond(const ContactScene& scene, const NearPlace& near) {
  const ContactFaces& faces = scene.surface.faces();
  const ContactFace& second = faces.faces[near.second];
  const SurfacePair& pair = *scene.rules[near.pair].pair;
  const MovingFace moving = scene.surface.face(near.second);
  Bond bond;
  if (near.is_node) {
    const SurfaceNode& node = faces.surface_nodes[near.first];
    static_cast<HeldPlace&>(bond) = place_of_node(scene, near.first, near.second);
    const auto foot = find_foot(scene, near.first, near.second, near.tolerance);
    if (!foot) return std::nullopt;
    bond.weights_1 = Eigen::Vector4d::UnitX();
    bond.weights_2 = corner_weights(foot->xi, foot->eta, moving.is_triangle);
    bond.rest = axes_of(moving.x).transpose() * (scene.surface.x(node.node) - moving.x * bond.weights_2);
    bond.share = near.share;
    bond.area = near.share * scene.surface.area_against(node, foot->normal);
    bond.penalty = make_pair_penalty(node.backing, &second.backing, pair).stiffness;
  } else {
    static_cast<HeldPlace&>(bond) = place_of_faces(scene, near.first, near.second);
    if (!bond_faces(scene.surface.face(near.first), moving, near.tolerance, bond)) return std::nullopt;
    bond.penalty = make_pair_penalty(faces.faces[near.first].backing, &second.backing, pair).stiffness;
  }
  const Hold& hold = *rule_of(scene, bond).place->hold;
  const bool is_in_forces = std::holds_alternative<SpringHold>(hold);
  bond.size = is_in_forces ? bond.share : bond.area;
  const double stiffness = bond_stiffness(hold, bond.size, bond.penalty);
  bond.springs << stiffness * bond.weights_1, stiffness * bond.weights_2;
  return bond;
}

void visit_place(HeldPlace& place, RowNumbers& row) {
  row(place.pair, place.is_swapped, place.first_place, place.second_place, place.is_node, place.nodes,
      place.springs, place.area, place.share);
}

void visit_tie(Tie& tie, RowNumbers& row) {
  visit_place(tie, row);
  row(tie.stiffness, tie.rest, tie.rest_energy, tie.n_points);
  for (TiePoint& point : tie.points)
    row(point.area, point.weights_1, point.weights_2, point.offset, point.force);
}

void visit_bond(Bond& bond, RowNumbers& row) {
  visit_place(bond, row);
  BondHistory& history = bond.history;
  row(bond.weights_1, bond.weights_2, bond.rest, bond.size, bond.penalty, bond.has_failed, history.worst,
      history.worst_traction, history.tangential_energy, history.gap_factor);
}

void visit_fading(FadingPlace& place, RowNumbers& row) {
  visit_place(place, row);
  row(place.forces, place.stored, place.n_steps, place.n_done);
}

bool is_bonded(const PairRule& rule) {
  return rule.place != nullptr && rule.place->hold && !rule.place->is_weld();
}

/// Whether both sides of a place are still there; it has their new numbers then.
bool keep_place(const ContactRenumbering& places, HeldPlace& place) {
  place.first_place = (place.is_node ? places.rows : places.faces)[place.first_place];
  place.second_place = places.faces[place.second_place];
  for (std::uint32_t& node : place.nodes) node = places.nodes[node];
  return place.first_place != ContactRenumbering::gone && place.second_place != ContactRenumbering::gone;
}

/// What a weld that fails passes on: of what is pressed together only the force along the surface, for the
/// rest is contact's from now on.
TieForces at_failure(const WeldHold& weld, const HeldPlace& place, TieForces forces) {
  forces.forces /= std::sqrt(weld_envelope(weld, place, forces));
  const Eigen::Vector3d on_first = forces.forces.leftCols<4>().rowwise().sum();
  if (forces.normal.dot(on_first) > 0.0)
    forces.forces -= (forces.normal * (forces.normal.transpose() * forces.forces)).eval();
  return forces;
}

}  // namespace

void HeldPlaces::add(const HeldPlace& place, const TieForces& forces, ContactSums& sums) {
  sums.add(place, forces);
  forces_.push_back({place, forces});
}

const HeldPlace& HeldPlaces::operator[](std::size_t i) const {
  if (i < ties_.size()) return ties_[i];
  i -= ties_.size();
  if (i < bonds_.size()) return bonds_[i];
  return fading_[i - bonds_.size()];
}

void HeldPlaces::archive(StateArchive& saved) {
  saved.rows("contact/ties", ties_, visit_tie);
  saved.rows("contact/bonds", bonds_, visit_bond);
  saved.rows("contact/fading", fading_, visit_fading);
}

void HeldPlaces::begin(const ContactScene& scene, const NearCandidates& candidates, GluedPlaces& glued) {
  make(scene, candidates, false, glued);
}

void HeldPlaces::renew(const ContactScene& scene, const NearCandidates& candidates, GluedPlaces& glued) {
  const auto is_old = [&](const HeldPlace& place) { return scene.rules[place.pair].has_changed; };
  for (const Tie& tie : ties_) {
    if (is_old(tie)) glued.remove(tie.is_node, tie.first_place, tie.is_node ? tie.pair : tie.second_place);
  }
  std::erase_if(ties_, is_old);
  std::erase_if(bonds_, is_old);
  std::erase_if(fading_, is_old);
  make(scene, candidates, true, glued);
}

void HeldPlaces::make(const ContactScene& scene, const NearCandidates& candidates, bool only_changed,
                      GluedPlaces& glued) {
  const auto is_due = [&](const PairRule& rule) { return !only_changed || rule.has_changed; };
  const auto ties =
      make_ties(scene, candidates.face_partners, candidates.node_faces, candidates.size_share,
                [&](const PairRule& rule) {
                  return is_due(rule) && (rule.law == ContactLaw::tied || rule.law == ContactLaw::welded);
                });
  for (const Tie& tie : ties) {
    if (rule_of(scene, tie).law == ContactLaw::welded)
      glued.add(tie.is_node, tie.first_place, tie.is_node ? tie.pair : tie.second_place);
    ties_.push_back(tie);
  }
  for (const NearPlace& near :
       find_near_places(scene, candidates.face_partners, candidates.node_faces, candidates.size_share,
                        [&](const PairRule& rule) { return is_due(rule) && is_bonded(rule); })) {
    if (auto bond = make_bond(scene, near)) bonds_.push_back(*bond);
  }
}

void HeldPlaces::glue(const ContactScene& scene, const ContactRecord& record, GluedPlaces& glued) {
  constexpr double any_gap = std::numeric_limits<double>::infinity();
  std::optional<Tie> tie;
  if (record.first.is_node()) {
    if (glued.add_node(record.first_place, record.pair))
      tie = make_node_tie(scene, {record.first_place, record.second_place, record.pair, true, any_gap,
                                  scene.rules[record.pair].pair->node_share()});
  } else if (glued.add_faces(record.first_place, record.second_place)) {
    tie = make_face_tie(scene, record.first_place, record.second_place, any_gap);
  }
  if (!tie) return;
  tie->rest_energy += record.stored();
  ties_.push_back(*tie);
}

void HeldPlaces::renumber(const ContactRenumbering& places) {
  const auto renumber_all = [&](auto& held) {
    std::size_t n = 0;
    for (auto& place : held) {
      if (keep_place(places, place)) held[n++] = place;
    }
    held.resize(n);
  };
  renumber_all(ties_);
  renumber_all(bonds_);
  renumber_all(fading_);
  std::erase_if(forces_, [&](HeldForces& held) { return !keep_place(places, held.place); });
}

void HeldPlaces::step(const ContactScene& scene, GluedPlaces& glued, ContactSums& sums) {
  step_fading(scene, sums);
  step_ties(scene, glued, sums);
  step_bonds(scene, sums);
}

void HeldPlaces::step_fading(const ContactScene& scene, ContactSums& sums) {
  if (scene.dt == 0.0) return;
  for (FadingPlace& place : fading_) {
    const TieVectors x = corners_of(scene, place);
    const TieForces before = find_fading_forces(place, x);
    ++place.n_done;
    TieForces now = find_fading_forces(place, x);
    // What the place held and what is done on it while it fades is lost.
    now.dissipated = before.stored - now.stored - work_of(scene, place, 0.5 * (before.forces + now.forces));
    add(place, now, sums);
  }
  std::erase_if(fading_, [](const FadingPlace& place) { return place.is_over(); });
}

void HeldPlaces::step_ties(const ContactScene& scene, GluedPlaces& glued, ContactSums& sums) {
  take_ties(scene, false, find_tie_forces, glued, sums);
}

void HeldPlaces::add_balanced(const ContactScene& scene, MomentumBalance& balance) {
  for (Tie& tie : ties_) {
    const PairRule& rule = rule_of(scene, tie);
    if (rule.is_active && rule.is_balanced) balance.add(tie);
  }
}

void HeldPlaces::take_balanced(const ContactScene& scene, const MomentumBalance& balance, GluedPlaces& glued,
                               ContactSums& sums) {
  const auto find_forces = [&](const Tie& tie, const TieVectors&) { return balance.find_forces(tie); };
  take_ties(scene, true, find_forces, glued, sums);
}

template <class FindForces>
void HeldPlaces::take_ties(const ContactScene& scene, bool is_balanced, const FindForces& find_forces,
                           GluedPlaces& glued, ContactSums& sums) {
  bool has_failed = false;
  for (Tie& tie : ties_) {
    const PairRule& rule = rule_of(scene, tie);
    if (!rule.is_active || rule.is_balanced != is_balanced) continue;
    const TieVectors x = corners_of(scene, tie);
    const TieForces forces = find_forces(tie, x);
    if (rule.law != ContactLaw::welded) {
      add(tie, forces, sums);
      continue;
    }
    const WeldHold& weld = std::get<WeldHold>(*rule.place->hold);
    if (weld_envelope(weld, tie, forces) <= 1.0) {
      add(tie, forces, sums);
      continue;
    }
    const TieForces last = at_failure(weld, tie, forces);
    add(tie, last, sums);
    fading_.push_back(make_fading(tie, last, x, rule.place->decay_cycles));
    glued.remove(tie.is_node, tie.first_place, tie.is_node ? tie.pair : tie.second_place);
    tie.area = 0.0;
    has_failed = true;
  }
  if (has_failed) std::erase_if(ties_, [](const Tie& tie) { return tie.area == 0.0; });
}

void HeldPlaces::step_bonds(const ContactScene& scene, ContactSums& sums) {
  bool has_failed = false;
  for (Bond& bond : bonds_) {
    const PairRule& rule = rule_of(scene, bond);
    if (!rule.is_active) continue;
    const TieVectors x = corners_of(scene, bond);
    const TieForces forces = step_bond(*rule.place->hold, x, bond);
    add(bond, forces, sums);
    if (!bond.has_failed) continue;
    has_failed = true;
    fading_.push_back(make_fading(bond, forces, x, rule.place->decay_cycles));
  }
  if (has_failed) std::erase_if(bonds_, [](const Bond& bond) { return bond.has_failed; });
}

void mark_close_places(const ContactScene& scene, const NearCandidates& candidates, PairRules& rules) {
  const auto near =
      find_near_places(scene, candidates.face_partners, candidates.node_faces, candidates.size_share,
                       [](const PairRule& rule) { return rule.model.far != nullptr; });
  for (const NearPlace& place : near) {
    if (place.is_node) {
      rules.mark_close_node(place.pair, place.first);
      continue;
    }
    Bond scratch;
    if (!bond_faces(scene.surface.face(place.first), scene.surface.face(place.second), place.tolerance,
                    scratch))
      continue;
    rules.mark_close_face(place.pair, place.first);
    rules.mark_close_face(place.pair, place.second);
  }
}

}  // namespace contactsim
