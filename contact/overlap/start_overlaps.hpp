// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// How the surfaces of a pair lie in each other at the start.
struct StartOverlap {
  PairIndex pair;
  std::uint32_t n_nodes = 0;  ///< of the mesh that lie behind the other side, or whose edges do
  std::uint32_t n_faces = 0;  ///< and edges that these lie behind
  std::uint32_t n_deep = 0;   ///< nodes deeper than half the thinner element: contact takes no notice of them
  double deepest = 0.0;       ///< [length]
  NodeIndex node;             ///< that lies there, the nearest one of an edge
  std::optional<NodeIndex> other;  ///< the nearest one of the other side; absent: a plane
  double size =
      0.0;  ///< of the face that it lies behind: its longest diagonal; 0 of planes and spheres [length]
};

/// Finds what overlaps on a mesh: nodes behind faces, planes and in spheres, edges that cross, and nodes of
/// one body inside the solids of another, however deep.
///   definition  of the model
/// Returns a row for each pair that overlaps, in order. Throws SolveError when a line or particle is nowhere.
std::vector<StartOverlap> find_start_overlaps(const ContactModel& model, const Mesh& mesh,
                                              const ContactDefinition& definition);

}  // namespace contactsim
