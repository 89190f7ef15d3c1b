// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/conditions/condition_scope.hpp"
#include "core/output/stored_variable.hpp"

namespace contactsim {

/// The variables that a region makes by USER VARIABLE and USER OUTPUT. Each keeps its values from one
/// computation to the next, so that one computed at every step may read what it was before.
/// Source: Sierra/SM 5.22, 9.4 and 10.1.
class UserOutputs {
 public:
  /// Adds the variables to those of the run. What cannot be computed is left out with a warning; functions
  /// and parts of the mesh that do not exist are errors. The variables must outlive it.
  UserOutputs(const ConditionScope& scope, OutputVariables& variables);

  /// Computes the variables in the order of the deck: those of COMPUTE AT EVERY STEP, and when the values are
  /// needed the others. Each is computed once a step, however often it is asked for.
  void compute(const OutputContext& context, bool are_needed);

  /// Whether what compute() would do reads more of a state than several ranks know of their own: values of
  /// all entities, and globals that are found from all nodes or elements. Reductions do not.
  bool read_all(bool are_needed) const;

  /// Saves or restores the values, whether the deck says USE WITH RESTART or not.
  void archive(StateArchive& saved);

 private:
  friend class UserOutputMaker;
  struct Computation {
    bool is_every_step = false;
    bool reads_all = false;
    std::function<void(const OutputContext&)> run;
  };
  std::vector<Computation> computations_;
  std::map<std::string, std::shared_ptr<StoredValues>> stored_;  // by location and name
  std::optional<std::int64_t> last_step_, last_needed_step_;     // for which it was done
};

}  // namespace contactsim
