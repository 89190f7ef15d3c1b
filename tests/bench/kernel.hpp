// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim::bench {

/// Work of the program that can be done again and again.
struct Kernel {
  double n_items = 0.0;           ///< elements, nodes or faces that it is reported for
  double n_bytes = 0.0;           ///< what a step has to move between memory and processor, see below [bytes]
  std::function<void()> prepare;  ///< before each step, not timed; may be empty
  std::function<void()> step;
};

/// What a kernel is set beside when it is watched.
enum class Reference { flops, memory };

/// A row of the table of kernels.
struct KernelRow {
  std::string_view name;
  std::string_view item;  ///< what n_items are
  Reference reference;
  std::size_t size;          ///< as it is timed: cells, shells or faces along an edge
  std::size_t counted_size;  ///< as its operations are counted, 0 if they are not
  Kernel (*make)(std::size_t size);
};

// Operations are counted on small meshes, since every instruction is stopped at: they have a third more nodes
// per element than large ones.
std::span<const KernelRow> element_kernels();
std::span<const KernelRow> contact_kernels();

// Bytes are counted by hand from the arrays that a step goes through, each once where it is read and once
// where it is written, as STREAM does; what a chunk of elements or a tree finds in a cache is not counted. So
// they are the least that memory has to move for arrays larger than the caches.

/// Elements: state and mass of the batches, numbers of nodes, positions and velocities (and angular ones) of
/// the mesh, the forces of the chunks as they are written and summed, and those of the nodes.
double bytes_of_forces(const Model& model, const State& state);

/// What the integrator adds: the motion, accelerations, masses and forces of the nodes.
double bytes_of_integration(const State& state);

}  // namespace contactsim::bench
