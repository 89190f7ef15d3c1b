// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/definition/output_variable.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/output/output_table.hpp"

namespace contactsim::test {

/// A run of two blocks between two steps: "soft" (id 10, elastic, density 2, 9 hexahedra in a row, volume 9)
/// and on top of it "hard" (id 20, elastic-plastic, density 3, 2 hexahedra, volume 2). Elements have the ids
/// 101, 102, ..., nodes 1001, 1002, ...; the nodes at x = 0 stand in the node set "wall". All is at rest and
/// undeformed until a test changes it.
class SampleRun {
 public:
  SampleRun();
  SampleRun(const SampleRun&) = delete;
  SampleRun& operator=(const SampleRun&) = delete;

  Mesh mesh;
  Model model;
  State state;

  OutputContext context() const { return {model, state}; }

  /// Moves all nodes: x = f X, v = l x.
  void deform(const Eigen::Matrix3d& f, const Eigen::Matrix3d& l);

  /// Sets a number that an element remembers at its integration point.
  ///   place  after those of the stress, or below 6 in it
  void set_point_value(std::size_t block, std::size_t element, std::size_t place, double value);
};

/// The request of a variable in one line of a deck.
VariableRequest request(VariableLocation location, const std::string& name, const std::string& component = "",
                        const std::string& alias = "");

}  // namespace contactsim::test
