// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_set.hpp"
#include "contact/surfaces/surface_pairs.hpp"

namespace contactsim {

class StateArchive;

/// What of pairs with a SEARCH DISTANCE was so near the other side at the start that it is looked at. With
/// sides that of SIDE B counts, else either of two will do. What deaths expose is looked at. Until distances
/// are set nothing is left out. Source: SRCHDIS of OptiStruct's CONTACT.
class StartReach {
 public:
  StartReach() = default;
  explicit StartReach(const SurfacePairs& pairs);

  /// Whether any pair has a SEARCH DISTANCE.
  bool exists() const { return exists_; }
  /// The distance of a pair, 0 before it is set, or without one [length].
  double distance(PairIndex pair) const { return limits_[pair].is_set() ? limits_[pair].distance : 0.0; }

  /// Sets the distance of a pair that has one; what is near is marked then.
  void set_distance(PairIndex pair, double distance) { limits_[pair].distance = distance; }
  void mark_face(PairIndex pair, FaceIndex face) { faces_.add(pair, face); }
  void mark_node(PairIndex pair, SurfaceNodeIndex row) { nodes_.add(pair, row); }
  void mark_edge(PairIndex pair, EdgeIndex edge) { edges_.add(pair, edge); }
  /// Whether something of a pair has been marked.
  bool has_any(PairIndex pair) const;

  /// Whether two faces, or edges, of these surfaces are looked at.
  bool may_meet_faces(PairIndex pair, FaceIndex first, FaceIndex second,
                      SurfaceIndex surface_of_first) const {
    return may_meet(pair, faces_, first, second, surface_of_first);
  }
  bool may_meet_edges(PairIndex pair, EdgeIndex first, EdgeIndex second,
                      SurfaceIndex surface_of_first) const {
    return may_meet(pair, edges_, first, second, surface_of_first);
  }
  /// Whether a surface node is looked at where it meets a face.
  bool may_meet_node(PairIndex pair, SurfaceNodeIndex row, FaceIndex face, SurfaceIndex surface_of_row) const;
  /// The same where it meets a plane.
  bool may_meet_plane(PairIndex pair, SurfaceNodeIndex row) const {
    return !limits_[pair].is_set() || nodes_.has(pair, row);
  }

  /// Goes over to other faces, nodes and edges: what is new is looked at.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  struct Limit {
    double distance = std::numeric_limits<double>::quiet_NaN();  // NaN: not set [length]
    OptionalIndex<SurfaceIndex> side_b;  // the surface whose entities count; none: either

    bool is_set() const { return distance >= 0.0; }
  };
  template <class AnIndex>
  bool may_meet(PairIndex pair, const PairSet<PairIndex, AnIndex>& near, AnIndex first, AnIndex second,
                SurfaceIndex surface_of_first) const {
    const Limit& limit = limits_[pair];
    if (!limit.is_set()) return true;
    if (!limit.side_b) return near.has(pair, first) || near.has(pair, second);
    return near.has(pair, limit.side_b == surface_of_first ? first : second);
  }

  bool exists_ = false;
  IndexedVector<PairIndex, Limit> limits_;
  PairSet<PairIndex, FaceIndex> faces_;
  PairSet<PairIndex, SurfaceNodeIndex> nodes_;
  PairSet<PairIndex, EdgeIndex> edges_;
};

}  // namespace contactsim
