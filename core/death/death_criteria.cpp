// SPDX-License-Identifier: BSD-3-Clause
#include "core/death/death_criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/death/death_sets.hpp"
#include "core/output/variable_test.hpp"

namespace contactsim {

namespace {

using Reduction = NodalCriterion::Reduction;

/// The test of a criterion and where its variable lives; null for those without a variable.
const VariableTest* test_of(const DeathCriterion& criterion, VariableLocation& location) {
  if (const auto* nodal = std::get_if<NodalCriterion>(&criterion)) {
    location = VariableLocation::nodal;
    return &nodal->test;
  }
  if (const auto* element = std::get_if<ElementCriterion>(&criterion)) {
    location = VariableLocation::element;
    return &element->test;
  }
  const auto* global = std::get_if<GlobalCriterion>(&criterion);
  location = VariableLocation::global;
  return global != nullptr ? &global->test : nullptr;
}

bool any_holds(const VariableTest& test, std::span<const double> values) {
  return std::ranges::any_of(values, [&](double value) { return holds(test, value); });
}

double reduced(Reduction reduction, double sum, double value) {
  if (reduction == Reduction::maximum) return value > sum ? value : sum;
  if (reduction == Reduction::minimum) return value < sum ? value : sum;
  return sum + value;
}

/// The values of all nodes of an element made one, a component at a time.
///   values  [n_nodes x n_components]
void reduce_nodes(Reduction reduction, std::span<const NodeIndex> nodes, std::span<const double> values,
                  std::span<double> reduced_values) {
  const std::size_t n = reduced_values.size();
  for (std::size_t c = 0; c < n; ++c) {
    double sum = values[nodes.front().value * n + c];
    for (const NodeIndex node : nodes.subspan(1)) sum = reduced(reduction, sum, values[node.value * n + c]);
    const bool is_mean = reduction == Reduction::average;
    reduced_values[c] = is_mean ? sum / static_cast<double>(nodes.size()) : sum;
  }
}

/// Calls take(place in the range, values) for every element of a range, at one point or at the mean of all.
template <class Take>
void visit_elements(const VariableSelection& selection, const OutputContext& context,
                    const EntityRange& range, const Take& take) {
  const std::size_t n = selection.n_components();
  std::vector<double> values(range.count * n);
  fill(selection, context, range, values);
  for (std::size_t i = 0; i < range.count; ++i) take(i, std::span<const double>(values).subspan(i * n, n));
}

}  // namespace

DeathCriteria::DeathCriteria(const ElementDeath& death, std::span<const ElementIndex> elements,
                             const OutputVariables& variables, Diagnostics& diagnostics)
    : elements_(elements), model_(variables.model()) {
  for (Criterion& criterion : without_material(death, diagnostics)) {
    VariableLocation location{};
    const VariableTest* test = test_of(criterion.definition, location);
    if (test != nullptr) {
      Diagnostics problems;
      const auto selection = find_selection(variables, location, test->variable, problems);
      // A criterion that is left out would change what dies.
      for (Diagnostic problem : problems.all()) {
        problem.severity = Severity::error;
        problem.id.clear();
        diagnostics.add(std::move(problem));
      }
      if (!selection) continue;
      criterion.selection = *selection;
      if (location == VariableLocation::element) criterion.ranges = ranges_of(*selection);
      if (location == VariableLocation::element && criterion.ranges.empty() && !elements.empty())
        diagnostics.add_error(test->variable.name.location,
                              fmt::format("no element of the set has {}", test->variable.name.text));
    }
    criteria_.push_back(std::move(criterion));
  }
}

void DeathCriteria::look_at(std::span<const ElementIndex> elements) {
  elements_ = elements;
  for (Criterion& criterion : criteria_) {
    if (!criterion.ranges.empty()) criterion.ranges = ranges_of(criterion.selection);
  }
}

bool DeathCriteria::reads_all() const {
  return std::ranges::any_of(criteria_, [](const Criterion& criterion) {
    return std::holds_alternative<GlobalCriterion>(criterion.definition);
  });
}

/// The criteria of a block, tests of element values in place of MATERIAL CRITERION.
std::vector<DeathCriteria::Criterion> DeathCriteria::without_material(const ElementDeath& death,
                                                                      Diagnostics& diagnostics) const {
  std::vector<Criterion> criteria;
  for (const DeathCriterion& criterion : death.criteria) {
    const auto* material = std::get_if<MaterialCriterion>(&criterion);
    if (material == nullptr) {
      criteria.push_back({criterion, false, {}, {}});
      continue;
    }
    std::set<std::string_view> failures;
    for (const ElementIndex element : elements_)
      failures.insert(model_.blocks[find_model_block(model_, element)].properties.law.kind().failure);
    failures.erase("");
    for (const std::string_view failure : failures) {
      const VariableReference variable{{std::string(failure), death.name.location}, "", std::nullopt};
      criteria.push_back({ElementCriterion{{variable, Comparison::greater_equal, 1.0},
                                           material->remaining_points.value_or(0)},
                          true,
                          {},
                          {}});
    }
    if (!failures.empty() || elements_.empty()) continue;
    diagnostics.add_error(
        death.name.location, "MATERIAL CRITERION: no element of the set has a material that fails by itself",
        "ml_ep_fail and johnson_cook with d1 to d4 do; CRITERION IS ELEMENT VALUE OF eqps >= "
        "<limit> kills by plastic strain");
  }
  return criteria;
}

std::vector<EntityRange> DeathCriteria::ranges_of(const VariableSelection& selection) const {
  constexpr std::size_t max_count = 1u << 14;  // of values at a time
  std::vector<EntityRange> ranges;
  std::uint32_t last = 0;
  for (const ElementIndex element : elements_) {
    const std::size_t b = find_model_block(model_, element);
    if (!selection.is_in_block(model_, b)) continue;
    const std::size_t first = element.value - model_.blocks[b].first_element.value;
    const bool goes_on = !ranges.empty() && ranges.back().block == b && element.value == last + 1 &&
                         ranges.back().count < max_count;
    last = element.value;
    if (goes_on) {
      ++ranges.back().count;
    } else {
      ranges.push_back({b, first, 1, selection.point});
    }
  }
  return ranges;
}

void DeathCriteria::mark_all(std::vector<std::uint8_t>& marks) const {
  for (const ElementIndex element : elements_) marks[element.value] = 1;
}

void DeathCriteria::mark_by_nodes(const Criterion& criterion, const NodalCriterion& nodal,
                                  const OutputContext& context, std::vector<std::uint8_t>& marks) const {
  const std::size_t n = criterion.selection.n_components();
  std::vector<double> values(model_.mesh->n_nodes() * n), element_values(n);
  fill(criterion.selection, context, {0, 0, model_.mesh->n_nodes(), {}}, values);
  for (const ElementIndex element : elements_) {
    reduce_nodes(nodal.reduction, model_.mesh->element_nodes(element), values, element_values);
    if (any_holds(nodal.test, element_values)) marks[element.value] = 1;
  }
}

void DeathCriteria::mark_by_elements(const Criterion& criterion, const ElementCriterion& element,
                                     const OutputContext& context, std::vector<std::uint8_t>& marks) const {
  std::vector<std::size_t> n_meeting;
  for (const EntityRange& range : criterion.ranges) {
    const ModelBlock& block = model_.blocks[range.block];
    const std::size_t first = block.first_element.value + range.first;
    const bool has_points = criterion.selection.variable->is_at_points && !criterion.selection.point;
    if (!element.remaining_points || !has_points) {
      visit_elements(criterion.selection, context, range, [&](std::size_t i, std::span<const double> values) {
        if (any_holds(element.test, values)) marks[first + i] = 1;
      });
      continue;
    }
    n_meeting.assign(range.count, 0);
    for (std::size_t point = 0; point < block.layout.n_points; ++point) {
      VariableSelection at_point = criterion.selection;
      at_point.point = point;
      EntityRange point_range = range;
      point_range.point = point;
      visit_elements(at_point, context, point_range, [&](std::size_t i, std::span<const double> values) {
        if (any_holds(element.test, values)) ++n_meeting[i];
      });
    }
    for (std::size_t i = 0; i < range.count; ++i) {
      const auto n_remain = static_cast<std::int64_t>(block.layout.n_points - n_meeting[i]);
      if (n_meeting[i] > 0 && n_remain <= *element.remaining_points) marks[first + i] = 1;
    }
  }
}

void DeathCriteria::mark_by(const Criterion& criterion, const OutputContext& context,
                            std::vector<std::uint8_t>& marks) const {
  if (const auto* nodal = std::get_if<NodalCriterion>(&criterion.definition)) {
    mark_by_nodes(criterion, *nodal, context, marks);
  } else if (const auto* element = std::get_if<ElementCriterion>(&criterion.definition)) {
    mark_by_elements(criterion, *element, context, marks);
  } else if (const auto* global = std::get_if<GlobalCriterion>(&criterion.definition)) {
    std::vector<double> values(criterion.selection.n_components());
    fill(criterion.selection, context, {}, values);
    if (any_holds(global->test, values)) mark_all(marks);
  } else {
    mark_all(marks);
  }
}

void DeathCriteria::mark(const OutputContext& context, std::vector<std::uint8_t>& marks) const {
  for (const Criterion& criterion : criteria_) mark_by(criterion, context, marks);
}

void DeathCriteria::mark_worst(const OutputContext& context, std::span<const std::uint8_t> may_die,
                               std::vector<std::uint8_t>& marks, WorstElement& worst) const {
  for (const Criterion& criterion : criteria_) {
    if (!criterion.is_of_material) {
      mark_by(criterion, context, marks);
      continue;
    }
    std::vector<std::uint8_t> failed(marks.size(), 0);
    mark_by(criterion, context, failed);
    for (const EntityRange& range : criterion.ranges) {
      const std::size_t first = model_.blocks[range.block].first_element.value + range.first;
      visit_elements(criterion.selection, context, range, [&](std::size_t i, std::span<const double> values) {
        if (failed[first + i] == 0 || may_die[first + i] == 0) return;
        const double value = *std::ranges::max_element(values);
        if (worst.element && !(value > worst.value)) return;
        worst = {ElementIndex{static_cast<std::uint32_t>(first + i)}, value};
      });
    }
  }
}

}  // namespace contactsim
