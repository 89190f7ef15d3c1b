// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/definition/region_parts.hpp"
#include "core/output/variable_selection.hpp"

namespace contactsim {

/// Why a run ends before its termination time.
struct EarlyEnd {
  std::string reason;                 ///< in words
  bool ends_procedure_alone = false;  ///< TERMINATE TYPE = PROCEDURE: the procedures after it are run
};

/// The SOLUTION TERMINATION blocks of a region: what ends the run early.
/// Source: Sierra/SM 5.22, solution termination.
class Terminations {
 public:
  /// A variable that is not known is an error. The variables must outlive it.
  Terminations(std::span<const SolutionTermination> definitions, const OutputVariables& variables,
               Diagnostics& diagnostics);

  /// Why the run ends with a state; nothing when it goes on. A value that is not a number fulfils no
  /// criterion.
  std::optional<EarlyEnd> find_end(const OutputContext& context) const;

  bool is_empty() const { return blocks_.empty(); }
  /// Whether it reads globals that are found from all nodes or elements.
  bool reads_all() const;

 private:
  struct Criterion {
    VariableSelection selection;
    TerminationCriterion definition;
    std::vector<EntityRange> ranges;  ///< all of the model
  };
  /// The first value that fulfils a criterion.
  static std::optional<double> find_fulfilling(const Criterion& criterion, const OutputContext& context);

  struct Block {
    std::vector<TimeRange> skipped_times;
    std::vector<Criterion> criteria;
    SolutionTermination::Scope scope;
  };
  std::vector<Block> blocks_;
};

}  // namespace contactsim
