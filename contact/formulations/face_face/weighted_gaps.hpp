// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/formulations/contact_step_context.hpp"
#include "contact/geometry/face_face_constraints.hpp"
#include "contact/interface_laws/friction.hpp"
#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// Two faces that overlap in a load step, shared out among the corners of the one that multipliers stand on.
struct WeightedOverlap {
  FaceIndex first, second;
  PairIndex pair;
  std::size_t candidate = 0;  ///< which pair of faces among the candidates
  bool is_of_first = true;    ///< whose corners the shares are of
  double weight = 1.0;        ///< by which it counts: less where the faces are about to be too far apart [1]
  const PairRule* rule = nullptr;
  PairPenalty penalty;
  CornerShares shares;
  std::array<double, 4> gaps{};    ///< that the mean one of each share counts as [length]
  std::array<double, 4> slopes{};  ///< over the mean one [1]
  /// Of the side with the corners along the other in the step, and what pairs of faces have held before,
  /// where there is friction [length].
  std::array<Eigen::Vector3d, 4> slips, held_slips;
  std::array<std::uint32_t, 4> nodes{};  ///< of each share, number in WeightedGaps::nodes()

  /// The sign of what the side with the corners feels, as the first side does [1].
  double sign() const { return is_of_first ? 1.0 : -1.0; }

  /// The area on which a share presses [length^2].
  double bearing_area(std::size_t share) const { return weight * slopes[share] * shares.corners[share].area; }
};

/// A surface node of the finer side of a pair and what it presses and drags with.
struct WeightedNode {
  PairIndex pair;
  SurfaceNodeIndex row;
  double area = 0.0;  ///< of overlaps by its shape function [length^2]
  double gap = 0.0;   ///< mean of the overlaps by the same [length]
  const PairRule* rule = nullptr;
  PairPenalty penalty;      ///< its stiffness is the mean by the same
  double multiplier = 0.0;  ///< depth by which it counts as deeper [length]
  double pressure = 0.0;    ///< >= 0 [force/length^2]
  double slope = 0.0;       ///< of the pressure over the depth, where it lies on [force/length^3]

  // With friction, of its own side, over what bears.
  double bearing = 0.0;                                    ///< area [length^2]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();        ///< unit; either way [1]
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();          ///< mean one of the step [length]
  Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();  ///< held before the step [length]
  FrictionStep friction;                                   ///< forces and energies over the area
  double friction_slope = 0.0;                             ///< of the limit of friction over the pressure [1]

  /// At which it presses, > 0 where it does [length].
  double depth() const { return multiplier - gap; }
  bool has_friction() const { return pressure > 0.0 && bearing > 0.0 && rule->friction > 0.0; }
  /// Of the tangential spring [force/length^3].
  double slip_stiffness() const { return static_slip_share * penalty.stiffness; }
};

/// The pressure of faces on faces in load steps. It is linear between the nodes of the finer side of a pair;
/// a node j presses by its multiplier and its weighted gap
///   p_j = p(m_j - g_j),   A_j = sum over overlaps of int N_j,
///   g_j = sum over overlaps of c(int N_j g / int N_j) int N_j / A_j,
/// with c(g) = g of what touches and less than that of what is open, and not by the gap of every point:
/// facets that bend past each other, whose gaps differ by what is large beside a stiff penalty's depth, then
/// neither part in places nor change stiffness from trial to trial. The forces are those of a potential, with
/// the stiffness sum of p'_j b_j b_j^T / A_j, b_j = A_j dg_j/du. Friction is that of the node too: its slip
/// is
///   s_j = sum over overlaps of c' int N_j (u_1 - u_2) / B_j,   B_j = sum of c' int N_j,
/// and a traction t_j by the return mapping of step_friction(), up to the limit for p_j, drags each overlap
/// by its part of B_j t_j. Source: weighted gaps and mortar pressure of Puso and Laursen, Comput. Methods
/// Appl. Mech. Eng. 193 (2004) 601-629, friction 4891-4913; active nodes by p_j > 0 of Hueeber and Wohlmuth,
/// 194 (2005) 3147-3166.
class WeightedGaps {
 public:
  ///   finer  which side of each pair multipliers stand on
  explicit WeightedGaps(IndexedVector<PairIndex, SurfaceIndex> finer) : finer_(std::move(finer)) {}
  SurfaceIndex finer_surface(PairIndex pair) const { return finer_[pair]; }
  /// Forgets all overlaps.
  void clear();
  /// Takes an overlap, in the order of candidates.
  void add(const ContactMesh& contact_mesh, WeightedOverlap overlap);
  /// Finds pressures and tractions once all overlaps are there.
  void find_tractions(const ContactStepContext& context);

  std::span<const WeightedNode> nodes() const { return nodes_; }
  std::span<const WeightedOverlap> overlaps() const { return overlaps_; }
  /// The overlap of a candidate, null without one.
  const WeightedOverlap* find(std::size_t candidate) const;
  const WeightedNode& node_of(const WeightedOverlap& overlap, std::size_t share) const {
    return nodes_[overlap.nodes[share]];
  }

 private:
  std::uint32_t number_of(PairIndex pair, SurfaceNodeIndex row);
  static void drag(const ContactStepContext& context, WeightedNode& node);

  IndexedVector<PairIndex, SurfaceIndex> finer_;
  std::vector<WeightedOverlap> overlaps_;
  std::vector<WeightedNode> nodes_;
  std::vector<OptionalIndex<std::uint32_t>> next_;  // of nodes_, the next one of the same row
  IndexedVector<SurfaceNodeIndex, OptionalIndex<std::uint32_t>> first_;  // of rows, their last node so far
};

/// What the motion of a contact node makes of a weighted gap and of the slip there.
struct WeightedGapMotion {
  std::uint32_t number = 0;  ///< of the gap, in WeightedGaps::nodes()
  ContactNodeIndex node;
  Eigen::Vector3d opens;  ///< derivative of the gap by the position of the node [1]
  double slips = 0.0;     ///< derivative of the slip, 0 without friction [1]
};

}  // namespace contactsim
