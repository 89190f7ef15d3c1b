// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/surfaces/surface_pairs.hpp"

namespace contactsim {

class StateArchive;

/// The gap between a face, surface node or edge and the other side of a pair at the start.
struct StartGap {
  std::uint32_t entity = 0;  ///< of the kind of the list that it is in
  PairIndex pair;
  double mean = 0.0;      ///< over the area in which the sides face each other [length]
  double smallest = 0.0;  ///< < 0 overlaps [length]
  double area = 0.0;      ///< of which the mean is; of a node its own; of edges any [length^2]
};

/// The start gaps of a pair, all together.
struct StartGapSummary {
  std::size_t n = 0;      ///< of faces, nodes and edges
  std::size_t n_far = 0;  ///< faces and nodes with a gap wider than they are
  double widest = 0.0;    ///< gap of these, either way [length]
};

/// Gaps of the start by the kind of what they are of, in any order.
struct FoundStartGaps {
  std::vector<StartGap> faces, nodes, edges;
};

/// Start gaps of one kind of entity, by entity and pair.
class StartGaps {
 public:
  /// Null when nothing was near.
  const StartGap* find(std::uint32_t entity, PairIndex pair) const {
    if (entity + std::size_t{1} >= begin_.size()) return nullptr;
    for (std::uint32_t k = begin_[entity]; k < begin_[entity + 1]; ++k) {
      if (gaps_[k].pair == pair) return &gaps_[k];
    }
    return nullptr;
  }
  /// The same of two, the one that is known for one that is not; both null when neither is.
  std::array<const StartGap*, 2> find_both(std::uint32_t first, std::uint32_t second, PairIndex pair) const;
  std::span<const StartGap> all() const { return gaps_; }
  /// Takes these instead, in any order; those of one entity and pair become one.
  void set(std::vector<StartGap> gaps);

 private:
  std::vector<std::uint32_t> begin_;  // [entities + 1] in gaps_
  std::vector<StartGap> gaps_;
};

/// What contact takes off the gaps of the mesh: CONTACT OFFSET everywhere; and where sides were near each
/// other at the start what INITIAL CLEARANCE, IGNORE INITIAL OVERLAP and OVERLAP RAMP TIME make of the gap g0
/// they had. With an offset d, a clearance c and a ramp of length T the gap that counts is
///   g - d,  g - (g0 - c),  g - d - min(g0 - d, 0),  g - d - min(g0 - d, 0) (1 - min(t / T, 1)).
/// A node keeps its own g0 wherever it slides; a face the mean of what lay before it, or where overlaps do
/// not count its deepest one, so that nothing pushes at the start. Two faces that both have one use the mean.
/// Source: CLEARANCE and GPAD of OptiStruct's CONTACT, *CLEARANCE and *CONTACT INTERFERENCE of Abaqus.
class GapOffsets {
 public:
  GapOffsets() = default;
  explicit GapOffsets(std::span<const SurfacePair> pairs);

  /// What is taken off the gap of two faces, of a surface node, or of two edges, now [length].
  double of_faces(PairIndex pair, FaceIndex first, FaceIndex second) const {
    return of(faces_, pair, first.value, second.value);
  }
  double of_node(PairIndex pair, SurfaceNodeIndex row) const {
    return of(nodes_, pair, row.value, row.value);
  }
  double of_edges(PairIndex pair, EdgeIndex first, EdgeIndex second) const {
    return of(edges_, pair, first.value, second.value);
  }
  /// How far apart on the mesh the sides of a pair may touch, at most [length].
  double reach(PairIndex pair) const { return rules_[pair].reach; }
  /// The same of all pairs [length].
  double largest_reach() const { return largest_reach_; }
  /// What is taken off gaps or added to them, at most [length].
  double largest_shift() const { return largest_shift_; }

  /// Whether the gaps of a pair, or of any, have to be known at the start.
  bool needs_start(PairIndex pair) const { return rules_[pair].settings.needs_start(); }
  bool needs_start() const;
  StartGapSummary summarize_start(PairIndex pair) const;
  /// Takes the gaps of the start, on the mesh as it is. Ramps begin at this time.
  void set_start(FoundStartGaps found, double time);

  /// Sets how much of the overlaps counts at a time.
  void activate(double time);
  /// The share of its overlaps that has come in since the time before [1].
  double ramp_progress(PairIndex pair) const { return rules_[pair].progress; }
  /// The overlap of the start at a contact point, if it comes in by a ramp; else 0 [length].
  double ramped_depth(const ContactPoint& point) const;
  /// Goes over to other faces, nodes and edges: what is new has no gap of the start.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  struct Rule {
    GapSettings settings;
    double offset = 0.0;         // CONTACT OFFSET [length]
    double overlap_share = 1.0;  // of an overlap of the start that is taken off now [1]
    double progress = 0.0;       // [1]
    double reach = 0.0;          // [length]
  };
  double of(const StartGaps& gaps, PairIndex pair, std::uint32_t first, std::uint32_t second) const;
  static double offset_for(const Rule& rule, const StartGap& gap);
  static double overlap_of(const Rule& rule, const StartGap& gap) {
    return std::max(rule.offset - gap.smallest, 0.0);
  }
  void set_gaps(FoundStartGaps found);
  void set_reach();

  IndexedVector<PairIndex, Rule> rules_;
  double start_time_ = 0.0;                           // of ramps [time]
  double largest_reach_ = 0.0, largest_shift_ = 0.0;  // [length]
  StartGaps faces_, nodes_, edges_;
};

}  // namespace contactsim
