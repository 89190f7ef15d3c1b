// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/mesh/output_field.hpp"

namespace contactsim {

class RankShare;

/// A run between two steps, as output sees it.
struct OutputContext {
  const Model& model;
  const State& state;
  /// Of several ranks, which know their own nodes and elements of the state; null where it is whole.
  const RankShare* share = nullptr;
};

/// Which entities' values are asked for.
struct EntityRange {
  std::size_t block = 0;             ///< position in Model::blocks, of element variables
  std::size_t first = 0, count = 1;  ///< nodes of the mesh, or elements of the block; 0, 1 for globals
  std::optional<std::size_t> point;  ///< integration point, from 0; absent: the mean of all
};

/// Row of the table of output variables. What can be filled changes nothing and may be filled by any thread.
struct OutputRow {
  std::string_view name;  ///< as decks ask for it, lower case
  FieldLocation location = FieldLocation::global;
  FieldShape shape = FieldShape::scalar;
  bool is_at_points = false;  ///< an element variable that each integration point has
  /// Sets the values, [count x n_components].
  void (*fill)(const OutputContext& context, const EntityRange& range, std::span<double> values) = nullptr;
  std::string_view help;           ///< one line with the dimension
  int list_size = 1;               ///< number of components of a list
  bool is_of_shells = false;       ///< only shells have it, of element variables
  bool is_always_written = false;  ///< every results file has it, of globals
  bool is_of_cohesive = false;     ///< only cohesive elements have it, of element variables
  bool reads_all = false;          ///< a global that is found from all nodes, or all elements

  int n_components() const { return shape == FieldShape::list ? list_size : component_count(shape); }
};

/// The dimension at the end of a line of help, "[force/length^2]"; "" without one.
std::string_view dimension_of(std::string_view help);

/// The variables that every run has. What materials remember and what the deck makes comes on top.
std::span<const OutputRow> global_output_rows();
std::span<const OutputRow> nodal_output_rows();
std::span<const OutputRow> element_output_rows();

/// The stress of an element at the range's point, element `range.first` + `i`; what is left of it when it
/// dies [force/length^2].
Eigen::Matrix3d stress_of(const OutputContext& context, const EntityRange& range, std::size_t i);

/// A symmetric tensor that a material remembers, along the global axes.
///   place  of its first component, as below
Eigen::Matrix3d material_tensor(const OutputContext& context, const EntityRange& range, std::size_t i,
                                std::size_t place);

/// One number that a material remembers, at the range's point.
///   place  in the state of an integration point, after its stress
double material_value(const OutputContext& context, const EntityRange& range, std::size_t i,
                      std::size_t place);

}  // namespace contactsim
