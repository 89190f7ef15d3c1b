// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "contact/interface_laws/gap_offsets.hpp"
#include "contact/interface_laws/pair_interface_law.hpp"
#include "contact/interface_laws/start_reach.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_set.hpp"
#include "contact/surfaces/surface_pairs.hpp"
#include "core/base/optional_index.hpp"
#include "core/conditions/active_times.hpp"

namespace contactsim {

class StateArchive;

/// A pair of surfaces, ready for the loops.
struct PairRule {
  const SurfacePair* pair = nullptr;
  ContactLaw law = ContactLaw::sliding;
  double friction = 0.0;  ///< Coulomb's coefficient; more than 0 wherever points that touch have friction [1]
  double activation_distance = 0.0;             ///< gaps up to this one feel the law [length]
  double begin_gap = 0.0;                       ///< at which the pressure begins [length]
  const InterfaceLaw* interface_law = nullptr;  ///< of models that are more than the above
  OptionalIndex<std::uint32_t> far;             ///< of HYBRID pairs: rule of what was far at the start
  bool is_active = true;                        ///< now
  bool is_balanced = false;                     ///< enforced by momentum balance
  bool has_changed = false;                     ///< has another model than before, by its period
  ActiveTimes times;
  PairInterfaceLaw model;             ///< that the above are of
  const InterfaceLaw* now = nullptr;  ///< the model of this period, of a TIME VARIANT one

  /// Whether the law pulls, or acts along the surface, across a gap.
  bool acts_apart() const {
    return interface_law != nullptr && (interface_law->pull || interface_law->rate_limit);
  }
  /// The same of any model that the pair may ever have.
  bool may_act_apart() const;
  /// Whether the pair has ties and never anything else.
  bool only_ties() const { return law == ContactLaw::tied && !far && !model.is_variant(); }
  /// The largest tangential force of what touches [force].
  ///   force  along the normal, >= 0 [force]
  ///   area   that touches [length^2]
  ///   rate   of slip [length/time]
  double slip_limit(double force, double area, double rate) const;
  /// Its derivative by the force, by a difference [1]. Precondition: force > 0.
  double slip_limit_slope(double force, double area, double rate) const;
  /// The same of a contact point, by its force, area and slip of the step.
  double slip_limit(const ContactPoint& point, double dt) const;
  /// Goes over to a model.
  void take(const InterfaceLaw& taken);
};

/// The pairs of a run by the surfaces that they are of.
class PairRules {
 public:
  PairRules() = default;
  /// The pairs must outlive this.
  ///   times  [n_pairs] at which each is active
  PairRules(const SurfacePairs& pairs, std::vector<ActiveTimes> times, std::size_t n_surfaces);

  /// Gives all pairs their models; before, those that never fail only tie and glue.
  ///   laws  none of them null
  void set_laws(IndexedVector<PairIndex, PairInterfaceLaw> laws);
  /// Says which pairs act now, and by which model.
  ///   is_on  whether any does
  void activate(double time, bool is_on);
  /// Whether some pair has another model than in the step before.
  bool have_changed() const;
  /// Goes over to other faces and nodes.
  void remap(const ContactRemap& remap);
  /// Remembers that a face, a surface node or an edge of a HYBRID pair was close to the other side at the
  /// start.
  void mark_close_face(PairIndex pair, FaceIndex face) { close_faces_.add(pair, face); }
  void mark_close_node(PairIndex pair, SurfaceNodeIndex row) { close_nodes_.add(pair, row); }
  void mark_close_edge(PairIndex pair, EdgeIndex edge) { close_edges_.add(pair, edge); }
  /// The rule of two faces of a pair, of a surface node, or of two edges: for HYBRID that of both close, or
  /// not.
  const PairRule& of_faces(PairIndex pair, FaceIndex first, FaceIndex second) const {
    const PairRule& rule = rules_[pair];
    return !rule.far || are_close(pair, first, second) ? rule : far_rules_[*rule.far];
  }
  const PairRule& of_node(PairIndex pair, SurfaceNodeIndex row) const {
    const PairRule& rule = rules_[pair];
    return !rule.far || is_close(pair, row) ? rule : far_rules_[*rule.far];
  }
  const PairRule& of_edges(PairIndex pair, EdgeIndex first, EdgeIndex second) const {
    const PairRule& rule = rules_[pair];
    return !rule.far || are_close_edges(pair, first, second) ? rule : far_rules_[*rule.far];
  }
  /// The rule of a contact point: for HYBRID that of what was close at the start, or not.
  const PairRule& of(const ContactPoint& point) const {
    if (point.is_of_edges) return of_edges(point.pair, point.first_edge(), point.second_edge());
    if (point.first.is_node()) return of_node(point.pair, point.row());
    return of_faces(point.pair, point.first_face(), point.second_face());
  }
  /// The largest gap that a pair's models may ever act over, or begin to press at [length].
  double max_activation_distance(PairIndex pair) const;
  /// How far apart on the mesh the sides of any pair may touch, at most [length].
  double largest_reach() const { return gap_offsets_.largest_reach() + largest_begin_gap_; }
  /// How far gaps of the mesh are from those that count, at most [length].
  double largest_shift() const { return gap_offsets_.largest_shift() + largest_begin_shift_; }
  IndexedSpan<PairIndex, const PairRule> rules() const { return rules_; }
  const PairRule& operator[](PairIndex pair) const { return rules_[pair]; }
  /// The pair of two surfaces in either order; nothing if they do not meet.
  OptionalIndex<PairIndex> find(SurfaceIndex surface, SurfaceIndex other) const {
    return table_[surface.value * n_surfaces_ + other.value];
  }
  bool has_friction() const;
  /// Whether what has touched may not part in some pair.
  bool may_hold() const {
    return std::ranges::any_of(rules_, [](const PairRule& rule) { return !rule.pair->separates; });
  }
  /// What is taken off the gaps of the mesh.
  const GapOffsets& gap_offsets() const { return gap_offsets_; }
  GapOffsets& gap_offsets() { return gap_offsets_; }
  /// What is looked at of pairs with a SEARCH DISTANCE.
  const StartReach& start_reach() const { return start_reach_; }
  StartReach& start_reach() { return start_reach_; }
  /// Saves or restores what is close at the start, and its gaps; then activate() has to be called.
  void archive(StateArchive& saved);

 private:
  bool are_close(PairIndex pair, FaceIndex first, FaceIndex second) const;
  bool are_close_edges(PairIndex pair, EdgeIndex first, EdgeIndex second) const;
  bool is_close(PairIndex pair, SurfaceNodeIndex row) const;
  OptionalIndex<PairIndex>& entry(SurfaceIndex first, SurfaceIndex second) {
    return table_[first.value * n_surfaces_ + second.value];
  }

  IndexedVector<PairIndex, PairRule> rules_;
  std::vector<PairRule> far_rules_;
  PairSet<PairIndex, FaceIndex> close_faces_;
  PairSet<PairIndex, SurfaceNodeIndex> close_nodes_;
  PairSet<PairIndex, EdgeIndex> close_edges_;
  // Of all models, either way for the latter [length].
  double largest_begin_gap_ = 0.0, largest_begin_shift_ = 0.0;
  GapOffsets gap_offsets_;
  StartReach start_reach_;
  std::vector<OptionalIndex<PairIndex>> table_;  // [n_surfaces x n_surfaces]
  std::size_t n_surfaces_ = 0;
};

}  // namespace contactsim
