// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/condition_lines.hpp"
#include "core/functions/function.hpp"
#include "core/mesh/stored_variables.hpp"

namespace contactsim {

/// Above the position of every node: the least of no positions.
inline constexpr std::uint32_t beyond_all_nodes = 0xffffffff;

/// What the function of a condition may look at, besides the time.
struct NodalFields {
  const Eigen::Matrix3Xd& model_coordinates;  ///< [3 x n_nodes] of the mesh [length]
  const Eigen::Matrix3Xd& coordinates;        ///< [3 x n_nodes] now [length]
  const Eigen::Matrix3Xd& velocity;           ///< [3 x n_nodes] [length/time]
};

/// Values of nodes at some times, linear in between; before the first and after the last they stay.
struct NodalTable {
  std::vector<double> times;     ///< not empty, rising [time]
  std::vector<NodeIndex> nodes;  ///< ascending
  std::vector<double> values;    ///< [n_times x n_nodes], time by time

  /// Precondition: the node is one of them.
  double at(double time, NodeIndex node) const;
};

/// The value of a condition: factor x function of time, or of what EXPRESSION VARIABLE lines read at a node,
/// or x values of a table.
/// Evaluating allocates nothing.
class ConditionFunction {
 public:
  /// The value that is the same always and everywhere.
  explicit ConditionFunction(double value, ConditionLabel label = {})
      : function_(value), label_(std::move(label)) {}
  ConditionFunction(NodalTable table, double factor, ConditionLabel label)
      : function_(0.0), factor_(factor), table_(std::move(table)), label_(std::move(label)) {}

  /// Whether nodes have values of their own.
  bool varies_in_space() const { return !inputs_.empty() || table_.has_value(); }

  /// The value at a time. Precondition: it does not vary in space. Throws SolveError, with the place of the
  /// condition, when it is not finite.
  double at(double time) const;

  /// The value at a node, which may be not finite.
  double at(double time, const NodalFields& fields, NodeIndex node) const;

  /// Throws the SolveError of a value that is not finite.
  ///   where  "at node 5"
  [[noreturn]] void fail(double time, const std::string& where) const;

 private:
  /// One number that the function reads.
  struct Input {
    enum class Field : std::uint8_t { time, coordinates, model_coordinates, displacement, velocity };
    Field field = Field::time;
    Eigen::Index component = 0;
  };
  friend class ConditionFunctionMaker;

  static double read(Input input, double time, const NodalFields& fields, NodeIndex node);

  Function function_;
  double factor_ = 1.0;
  std::vector<Input> inputs_;
  std::optional<NodalTable> table_;  ///< in place of the function
  ConditionLabel label_;
};

/// The function that a condition names, times its scale factor; 1 times the factor when it names none.
/// Nothing when an error was added: unknown names, EXPRESSION VARIABLE lines that read what conditions do not
/// know.
std::optional<ConditionFunction> make_condition_function(const ScaledFunction& scaled, ConditionLabel label,
                                                         const ConditionScope& scope);

}  // namespace contactsim
