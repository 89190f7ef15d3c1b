// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What overlap removal did to a pair of surfaces.
struct OverlapMoves {
  PairIndex pair;
  std::uint32_t n_nodes = 0;  ///< that were moved
  double deepest = 0.0;       ///< overlap that was found [length]
  double largest = 0.0;       ///< move of a node [length]
  NodeIndex largest_node;     ///< the first of those that moved so far
  double left = 0.0;          ///< deepest overlap that is still there, as nodes are held [length]
  double widest = 0.0;        ///< gap that was to be closed [length]
  double left_open = 0.0;     ///< widest of these gaps that is still there [length]
  double mean_square = 0.0;   ///< root of the mean square of the moves [length]
  std::uint32_t n_again = 0;  ///< nodes that an earlier pair had moved, too
  bool operator==(const OverlapMoves&) const = default;
};

/// An element that overlap removal would turn inside out, and the pair that moves its nodes farthest.
struct TurnedElement {
  ElementIndex element;
  PairIndex pair;
};

/// Coordinates without overlap, and how they came about.
struct OverlapRemoved {
  Eigen::Matrix3Xd coordinates;          ///< 3 x n_nodes [length]
  std::vector<OverlapMoves> moves;       ///< of the pairs that overlapped, in order
  std::int64_t n_passes = 0;             ///< that moved nodes
  std::int64_t n_body_passes = 0;        ///< that moved bodies, before those
  std::optional<ElementIndex> squeezed;  ///< solid that has lost most of its volume, where gaps are closed
  double volume_share = 1.0;             ///< of that volume that is left, > 1 grown [1]
  std::vector<TurnedElement> turned;     ///< ascending; the coordinates are of no use when there are any
};

/// Moves nodes of contact faces out of the faces of paired surfaces that they lie behind, along the face's
/// normal: half the way in each pass where the nodes of the face may move too, all of it out of planes and of
/// faces that are held, and one by one in the last pass. A pass takes the pairs in order. A node lies behind
/// a face when it is over it, no deeper than the pair's overlap normal tolerance (automatic: half the
/// thickness of the element behind the face; behind a plane, of the node's own elements), and its own surface
/// is turned towards the face. Beside a face counts as over it up to a quarter of the depth, or the pair's
/// overlap tangential tolerance.
///
/// Points of lofted shells are such nodes, and their normals those of any of their faces; they take the node
/// of the mesh along that they hang on, with all that hangs on it, so that shells keep their thickness. Edges
/// of shells that cross others where no node lies as deep part by half the way each. Balls around particles
/// and around the nodes of lines go out of faces all the way; a held one has the face give way. Rods and
/// spheres in each other, and capsules in sharp edges, part by half the way each. These may automatically be
/// as deep as their radius. Passes over lofts have a limit of their own, SHELL OVERLAP ITERATIONS, and
/// overlap of lofts no deeper than the SHELL OVERLAP TOLERANCE is left. What the mesh joins within its
/// thickness never counts as overlap. Bodies that lie deeper in solids of others than half an element go
/// apart as wholes before that (BodyParting).
///
/// Where pairs close gaps (GapClosure), that comes last. Without INITIAL OVERLAP REMOVAL these pairs are the
/// only ones whose overlap is removed.
///   definition  of the model
///   is_held     [n_nodes] 0 moves, held_fully stays, the body of held_in_part does not go as a whole; or
///   empty
/// Throws SolveError when a line or particle is nowhere. Source: Sierra/SM 5.22, 8.9.4.
OverlapRemoved remove_overlap(const ContactModel& model, const Mesh& mesh,
                              const ContactDefinition& definition, std::span<const std::uint8_t> is_held);

}  // namespace contactsim
