// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/solid_kernel.hpp"

/// Base vectors of elements with uniform gradients. The nodal values of a field are known by their sums with
/// vectors that are orthogonal to each other and equally long, nodal forces by the amounts of these vectors
/// that they are made of: products of a field and of forces are the same in sums and amounts as they are at
/// the nodes. A geometry states
///   n_nodes, n_base   base vectors; a motion of all nodes alike need not be among them
///   n_gradient        the first base vectors, those by whose sums the volume changes
///   n_modes           hourglass modes, nodal motions without a mean gradient
///   base_norm         the square of the Euclidean norm of every base vector
///   mode_norm         the Euclidean norm of every hourglass mode
/// and has
///   base_sums(values)      of a value at each node
///   at_nodes(amounts)      the transpose: base vectors times amounts
///   volume_gradient(x)     derivatives of the volume by the base sums of the coordinates, which are also
///                          the volume times the mean gradients of the shape functions [length^2]
///   mode_sums(sums)        the modes summed with a value at each node
///   add_modes(a, amounts)  adds the modes times a: the transpose
namespace contactsim {

/// A vector of each base vector, [component][base vector].
template <class Geometry>
using BaseVectors = NodeVectors<Geometry::n_base>;

/// The base vectors of nodes themselves.
template <std::size_t n>
struct NodeBase {
  static constexpr std::size_t n_nodes = n, n_base = n, n_gradient = n;
  static constexpr double base_norm = 1.0;
  static const std::array<Lanes, n>& base_sums(const std::array<Lanes, n>& values) { return values; }
  static const std::array<Lanes, n>& at_nodes(const std::array<Lanes, n>& amounts) { return amounts; }
};

/// The base sums of vectors at the nodes.
template <class Geometry>
BaseVectors<Geometry> base_sums(const NodeVectors<Geometry::n_nodes>& v) {
  return {Geometry::base_sums(v[0]), Geometry::base_sums(v[1]), Geometry::base_sums(v[2])};
}

template <class Geometry>
SolidMotion<Geometry::n_base> base_motion(const SolidMotion<Geometry::n_nodes>& motion) {
  return {base_sums<Geometry>(motion.x), base_sums<Geometry>(motion.v), motion.mass, motion.dt};
}

template <class Geometry>
void set_nodal_forces(const BaseVectors<Geometry>& forces, SolidStep<Geometry::n_nodes>& step) {
  for (std::size_t i = 0; i < 3; ++i) step.force[i] = Geometry::at_nodes(forces[i]);
}

}  // namespace contactsim
