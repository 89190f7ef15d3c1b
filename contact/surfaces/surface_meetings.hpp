// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "contact/surfaces/surface_pairs.hpp"
#include "core/definition/interaction.hpp"

namespace contactsim {

/// Two surfaces in the order in which an interaction names them.
struct Meeting {
  SurfaceIndex first, second;
  bool has_sides = false;
};

/// Two surfaces in either order.
using PairKey = std::pair<SurfaceIndex, SurfaceIndex>;

/// Which surfaces can meet, and who of two gives faces and who nodes: nodes meet faces and planes only,
/// planes never each other. Source: Sierra/SM 5.22, 8.6.
class SurfaceMeetings {
 public:
  /// `surfaces` must outlive this.
  explicit SurfaceMeetings(const SurfaceList& surfaces);

  /// The surfaces with these names; names that there are not are passed over.
  std::vector<SurfaceIndex> positions_of(const std::vector<DeckName>& names) const;
  /// All that an interaction names. Two surfaces that both ways name have no sides. ALL of a side is every
  /// surface; by it alone a surface meets itself only where that is excluded.
  std::map<PairKey, Meeting> meetings_of(const Interaction& interaction) const;
  /// Every pair among the surfaces; of one alone it with itself; beside ALL each of them with every surface.
  std::map<PairKey, Meeting> meetings_of(const SurfaceExclusion& exclusion) const;
  bool can_meet(const Meeting& meeting) const;
  bool has_empty_side(const Meeting& meeting) const;
  /// Sets who gives what. A pair that only one order can serve gets that order, whatever the sides say.
  void settle(const Meeting& meeting, SurfacePair& pair) const;

 private:
  /// What a surface can bring into a pair.
  struct Parts {
    bool faces = false;  ///< of elements or of lofts
    bool nodes = false;  ///< of a surface of nodes
    bool planes = false;
  };
  /// The same with every surface for ALL, unless a surface has that name.
  std::vector<SurfaceIndex> positions_with_all(const std::vector<DeckName>& names) const;
  bool is_all(const DeckName& name) const;
  static bool can_meet_one_way(const Parts& faces, const Parts& nodes) {
    return (faces.faces || faces.planes) && (nodes.faces || nodes.nodes);
  }

  const SurfaceList& surfaces_;
  IndexedVector<SurfaceIndex, Parts> parts_;
  std::unordered_map<std::string, SurfaceIndex> positions_;  // by folded name
};

}  // namespace contactsim
