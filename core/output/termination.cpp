// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/termination.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/output/reduction.hpp"
#include "core/output/variable_test.hpp"

namespace contactsim {

namespace {

OutputReduction reduction_of(NodalCriterion::Reduction reduction) {
  if (reduction == NodalCriterion::Reduction::average) return OutputReduction::average;
  return reduction == NodalCriterion::Reduction::maximum ? OutputReduction::maximum
                                                         : OutputReduction::minimum;
}

std::vector<EntityRange> all_entities(const VariableSelection& selection, const Model& model) {
  if (selection.variable->location == FieldLocation::global) return {{0, 0, 1, {}}};
  if (selection.variable->location == FieldLocation::node) return {{0, 0, model.mesh->n_nodes(), {}}};
  std::vector<EntityRange> ranges;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    ranges.push_back({b, 0, model.blocks[b].n_elements, {}});
  return ranges;
}

}  // namespace

Terminations::Terminations(std::span<const SolutionTermination> definitions, const OutputVariables& variables,
                           Diagnostics& diagnostics) {
  for (const SolutionTermination& definition : definitions) {
    Block& block = blocks_.emplace_back();
    block.skipped_times = definition.skipped_times;
    block.scope = definition.scope;
    for (const TerminationCriterion& criterion : definition.criteria) {
      Diagnostics problems;
      const auto selection = find_selection(variables, criterion.location, criterion.test.variable, problems);
      // A criterion that is left out would change when the run ends.
      for (Diagnostic problem : problems.all()) {
        problem.severity = Severity::error;
        problem.id.clear();
        diagnostics.add(std::move(problem));
      }
      if (selection)
        block.criteria.push_back({*selection, criterion, all_entities(*selection, variables.model())});
    }
  }
}

bool Terminations::reads_all() const {
  const auto reads = [](const Criterion& criterion) { return criterion.selection.variable->reads_all; };
  return std::ranges::any_of(blocks_,
                             [&](const Block& block) { return std::ranges::any_of(block.criteria, reads); });
}

std::optional<double> Terminations::find_fulfilling(const Criterion& criterion,
                                                    const OutputContext& context) {
  const VariableTest& test = criterion.definition.test;
  std::optional<double> found;
  const auto look = [&](std::span<const double> values) {
    for (const double value : values) {
      if (!found && holds(test, value)) found = value;
    }
  };
  if (criterion.definition.reduction) {
    look(reduce(reduction_of(*criterion.definition.reduction), criterion.selection, criterion.ranges,
                context));
  } else {
    visit_values(criterion.selection, criterion.ranges, context,
                 [&](const EntityRange&, std::span<const double> values) { look(values); });
  }
  return found;
}

std::optional<EarlyEnd> Terminations::find_end(const OutputContext& context) const {
  const double time = context.state.time;
  for (const Block& block : blocks_) {
    const bool is_skipped = std::any_of(block.skipped_times.begin(), block.skipped_times.end(),
                                        [&](const TimeRange& r) { return r.from <= time && time <= r.to; });
    if (is_skipped) continue;
    for (const Criterion& criterion : block.criteria) {
      const auto found = find_fulfilling(criterion, context);
      if (!found) continue;
      const VariableTest& test = criterion.definition.test;
      return EarlyEnd{fmt::format("{} is {:.6g} {} {:.6g}", test.variable.name.text, *found,
                                  symbol(test.comparison), test.value),
                      block.scope == SolutionTermination::Scope::procedure};
    }
  }
  return std::nullopt;
}

}  // namespace contactsim
