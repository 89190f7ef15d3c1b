// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/lanes.hpp"
#include "core/elements/beam_shape.hpp"
#include "core/elements/cohesive_parts.hpp"
#include "core/elements/discrete_parts.hpp"
#include "core/elements/element_properties.hpp"
#include "core/elements/node_sums.hpp"
#include "core/elements/node_vector.hpp"
#include "core/elements/shell_settings.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

struct ElementFormulation;

/// Where the numbers of a batch stand in its state: at each integration point the stress (xx yy zz xy yz zx)
/// and what the material remembers, then the element's own (hourglass forces), then the work of the stress.
struct StateLayout {
  std::size_t n_points = 0;
  std::size_t point_size = 0;  ///< Lanes per integration point
  std::size_t n_own = 0;

  std::size_t energy() const { return n_points * point_size + n_own; }
  std::size_t size() const { return energy() + 1; }  ///< Lanes per batch
};

/// Batches that are advanced together. Their nodes are numbered anew from 0, so that coordinates, velocities
/// and forces of the chunk fit into a cache. Chunks do not depend on the number of threads.
struct BatchChunk {
  std::size_t first_batch = 0, n_batches = 0;
  std::size_t first_node = 0, n_nodes = 0;  ///< in ModelBlock::chunk_nodes
  bool is_subcycled = false;                ///< advanced in parts of a step, Subcycler
};

/// The elements of one block of the mesh, in batches of n_lanes; the last batch is filled up with copies of
/// the last element, whose numbers count nowhere. Const after set-up.
struct ModelBlock {
  static constexpr std::size_t batches_per_chunk = 64;

  const ElementFormulation* element = nullptr;
  std::uint32_t mesh_block = 0;  ///< position in the mesh
  ElementIndex first_element;
  std::size_t n_elements = 0;
  ElementProperties properties;
  bool is_rigid = false;  ///< a part of a rigid body: it has no stress
  /// [n_batches] which elements die when they turn inside out, a bit each; empty when none does
  std::vector<std::uint8_t> dies_inverted;
  std::string material;  ///< and its model, for people: "steel (elastic)"
  StateLayout layout;
  std::vector<BatchChunk> chunks;
  std::vector<std::uint32_t> chunk_nodes;  ///< of the mesh, chunk by chunk
  std::vector<ChunkNode> nodes;            ///< [n_batches x n_nodes x n_lanes] of the chunk
  std::vector<Lanes> mass;                 ///< [n_batches] [mass]
  ShellSettings shell;                     ///< of shells
  std::vector<Lanes> thickness;            ///< [n_batches] of shells at the start [length]
  BeamShapeSettings beam;                  ///< of lines
  Preload preload;                         ///< of trusses
  DiscreteParts discrete;                  ///< of springs, dampers and point masses
  CohesiveParts cohesive;                  ///< of cohesive elements
  std::vector<Lanes> section;  ///< [n_batches] of lines [length^2], of particles the radius [length]
  std::vector<Lanes> inertia;  ///< [n_batches] of elements whose nodes turn [mass length^2]
  /// [n_batches x 6] the material's directions 1 and 2 at rest: of solids in coordinates, of shells in their
  /// own axes; empty of materials without
  std::vector<Lanes> directions;
  NodeSums sums;  ///< from the nodes of chunks to those of the mesh, subcycled chunks left out

  std::size_t n_batches() const { return mass.size(); }
  /// Where shells remember how their thickness has grown, as ShellMemory [1].
  std::size_t thickness_growth() const { return layout.energy() - 1; }
  std::span<const std::uint32_t> nodes_of(const BatchChunk& chunk) const {
    return {chunk_nodes.data() + chunk.first_node, chunk.n_nodes};
  }
};

/// What the elements of a block remember.
struct ModelBlockState {
  std::vector<Lanes> values;        ///< [n_batches x layout.size()] [as StateLayout]
  std::vector<NodeVector> forces;   ///< [chunk_nodes] on the nodes of each chunk, of the last step [force]
  std::vector<NodeVector> moments;  ///< the same of elements whose nodes turn, else empty [force length]
  /// [n_batches] what is left of each element's forces: 1 of one that lives, 0 of a dead one, in between
  /// while it dies; empty when none can die [1]
  std::vector<Lanes> life;
  double hourglass_work = 0.0;  ///< done on what resists hourglasses since the start [energy]

  std::span<Lanes> batch(const StateLayout& layout, std::size_t batch) {
    return {values.data() + batch * layout.size(), layout.size()};
  }
  double life_of(std::size_t element) const {
    return life.empty() ? 1.0 : life[element / n_lanes](static_cast<Eigen::Index>(element % n_lanes));
  }
  /// A number of one element of the block, by its place in the layout.
  double at(const StateLayout& layout, std::size_t element, std::size_t place) const {
    return values[element / n_lanes * layout.size() + place](static_cast<Eigen::Index>(element % n_lanes));
  }
};

/// Builds the block. Precondition: the element is of the mesh block's shape; it has elements.
///   mesh_block  position in the mesh
ModelBlock make_solid_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                            const ElementProperties& properties);

/// The same of shells and membranes. The nodes of shells have an equal share of an inertia each: a sphere's
/// of radius^2 = A / 8, or that of a bar across the thickness when it is larger, which is what keeps turning
/// out of the stable step. Source: Hughes, Cohen and Haroun, Nucl. Eng. Des. 46 (1978) 203-222.
///   thickness  [n_elements] > 0 [length]
ModelBlock make_shell_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                            const ElementProperties& properties, const ShellSettings& settings,
                            std::span<const double> thickness);

/// The same of lines and particles. The nodes of beams have the mass times 2 I / A about any axis, I the
/// larger second moment: of a round rod that is its polar inertia m r^2 / 2, so that it rolls as it should;
/// about the axes across, twice that of a slice, which bounds what bending takes from the stable step.
///   sizes  [n_elements] cross-section of lines [length^2], radius of particles [length]
ModelBlock make_line_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                           const ElementProperties& properties, const BeamShapeSettings& beam,
                           std::span<const double> sizes);

/// The same of springs, dampers and point masses, whose mass is density x their volume; lengths, stiffness
/// and inertia are still to be set.
///   sizes  [n_elements] cross-section of lines [length^2]
ModelBlock make_discrete_block(const Mesh& mesh, std::uint32_t mesh_block, const ElementFormulation& element,
                               double density, std::span<const double> sizes);

/// Makes the chunks of a block anew, such that none has both batches that are subcycled and others.
///   is_subcycled  [n_batches]
void split_chunks(const Mesh& mesh, std::span<const std::uint8_t> is_subcycled, ModelBlock& block);

/// The places in chunk_nodes of the chunks that are subcycled, or of the others, ascending.
std::vector<std::uint32_t> find_places(const ModelBlock& block, bool is_subcycled);

/// The state of undeformed elements at rest.
ModelBlockState make_state(const ModelBlock& block);

}  // namespace contactsim
