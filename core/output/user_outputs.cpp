// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/user_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "core/definition/simulation.hpp"
#include "core/functions/expression_place.hpp"
#include "core/output/element_geometry.hpp"
#include "core/output/entity_ranges.hpp"
#include "core/output/function_inputs.hpp"
#include "core/output/global_expression.hpp"
#include "core/output/reduction.hpp"
#include "core/output/stored_variable.hpp"

namespace contactsim {

namespace {

using Storage = std::shared_ptr<StoredValues>;

FieldLocation field_location(UserVariable::Place place) {
  if (place == UserVariable::Place::node) return FieldLocation::node;
  return place == UserVariable::Place::element ? FieldLocation::element : FieldLocation::global;
}

FieldShape field_shape(const UserVariable& variable) {
  using S = UserVariable::Shape;
  if (variable.shape == S::vector) return FieldShape::vector;
  if (variable.shape == S::sym_tensor) return FieldShape::symmetric_tensor;
  if (variable.shape == S::full_tensor) return FieldShape::full_tensor;
  return variable.length == 1 ? FieldShape::scalar : FieldShape::list;
}

// A variable of the whole model's nodes from those of elements, weighted by their volumes now.
void extrapolate(const VariableSelection& selection, std::span<const EntityRange> ranges,
                 const OutputContext& context, std::span<double> values) {
  const std::size_t n = selection.n_components();
  std::vector<double> weights(context.model.mesh->n_nodes(), 0.0);
  std::fill(values.begin(), values.end(), 0.0);
  visit_values(
      selection, ranges, context, [&](const EntityRange& part, std::span<const double> element_values) {
        const ElementBlock& block = context.model.mesh->blocks()[context.model.blocks[part.block].mesh_block];
        for (std::size_t i = 0; i < part.count; ++i) {
          const auto nodes = block.element_nodes(static_cast<std::uint32_t>(part.first + i));
          const ElementVectors x = gather(nodes, context.state.coordinates);
          const double volume = solid_volume(x, volume_gradient(topology(block.shape), x));
          for (const NodeIndex node : nodes) {
            weights[node.value] += volume;
            for (std::size_t c = 0; c < n; ++c)
              values[node.value * n + c] += volume * element_values[i * n + c];
          }
        }
      });
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (weights[v / n] != 0.0) values[v] /= weights[v / n];
  }
}

}  // namespace

/// Makes the variables and computations of one region.
class UserOutputMaker {
 public:
  UserOutputMaker(const ConditionScope& scope, OutputVariables& variables, UserOutputs& outputs)
      : scope_(scope), variables_(variables), outputs_(outputs) {}

  void make() {
    for (const UserVariable& variable : scope_.region.user_variables) add(variable);
    for (const UserOutput& output : scope_.region.user_outputs) {
      output_ = &output;
      label_ = {"the user output", output.name.location};
      for (const ComputedVariable& variable : output.variables)
        std::visit([&](const auto& alternative) { add(alternative); }, variable);
    }
  }

 private:
  void warn(const DeckName& at, std::string text) {
    scope_.diagnostics.add_warning("output-not-computed", at.location, std::move(text), "",
                                   static_cast<int>(at.text.size()));
  }

  std::vector<EntityRange> find_ranges(FieldLocation location) {
    if (location == FieldLocation::global) return {{0, 0, 1, {}}};
    if (location == FieldLocation::node) return find_node_ranges(output_->set, label_, scope_);
    return find_element_ranges(output_->set, label_, scope_, variables_.model());
  }

  void compute(bool reads_all, std::function<void(const OutputContext&)> run) {
    outputs_.computations_.push_back({output_->is_every_step, reads_all, std::move(run)});
  }

  // Storage of a variable; one that the deck has made before goes on. Null when that has another size.
  Storage store(const DeckName& name, FieldLocation location, FieldShape shape, std::vector<double> initial,
                std::vector<std::uint8_t> in_blocks = {}, const std::string& dimension = {}) {
    Storage& storage = outputs_.stored_[fmt::format("{}_{}", static_cast<int>(location), fold(name.text))];
    if (storage != nullptr) {
      if (storage->n_components() == initial.size()) return storage;
      warn(name, fmt::format("{} has {} numbers, and {} are computed", name.text, storage->n_components(),
                             initial.size()));
      return nullptr;
    }
    storage = std::make_shared<StoredValues>(variables_.model(), location, std::move(initial));
    OutputVariable variable;
    variable.name = canonical_variable_name(name.text);
    variable.location = location;
    variable.shape = shape;
    variable.in_blocks = std::move(in_blocks);
    variable.dimension = dimension;
    add_stored_variable(variables_, std::move(variable), storage);
    return storage;
  }

  Storage store_like(const DeckName& name, FieldLocation location, const VariableSelection& selection) {
    const FieldShape shape = selection.is_one_of_several() ? FieldShape::scalar : selection.variable->shape;
    return store(name, location, shape, std::vector<double>(selection.n_components(), 0.0), {},
                 selection.variable->dimension);
  }

  void add(const UserVariable& variable) {
    const FieldShape shape = field_shape(variable);
    const std::size_t n = static_cast<std::size_t>(
        shape == FieldShape::list ? variable.length : std::int64_t{component_count(shape)});
    std::vector<double> initial = variable.initial_values;
    if (initial.empty()) initial.push_back(0.0);
    if (initial.size() == 1) initial.resize(n, initial[0]);
    if (initial.size() != n) {
      scope_.diagnostics.add_error(
          variable.name.location,
          fmt::format("{} has {} numbers and {} initial values", variable.name.text, n, initial.size()));
      return;
    }
    store(variable.name, field_location(variable.place), shape, std::move(initial), find_blocks(variable));
  }

  std::vector<std::uint8_t> find_blocks(const UserVariable& variable) {
    if (variable.blocks.empty() || variable.place != UserVariable::Place::element) return {};
    EntitySet set;
    set.blocks = variable.blocks;
    const Model& model = variables_.model();
    std::vector<std::uint8_t> in_blocks(model.blocks.size(), 0);
    const ConditionLabel label{"the user variable", variable.name.location};
    for (const EntityRange& range : find_element_ranges(set, label, scope_, model))
      in_blocks[range.block] = 1;
    return in_blocks;
  }

  void add(const ReducedVariable& reduced) {
    const auto selection =
        find_selection(variables_, reduced.source_location, reduced.source, scope_.diagnostics);
    if (!selection) return;
    if (selection->variable->location == FieldLocation::global)
      return warn(reduced.source.name, fmt::format("{} is one value already", reduced.source.name.text));
    auto ranges = find_ranges(selection->variable->location);
    const Storage values = store_like(reduced.name, FieldLocation::global, *selection);
    if (values == nullptr) return;
    compute(false, [selection = *selection, ranges = std::move(ranges), values,
                    reduction = reduced.reduction](const OutputContext& context) {
      const std::vector<double> results = reduce(reduction, selection, ranges, context);
      std::copy(results.begin(), results.end(), values->at(EntityRange{}).begin());
    });
  }

  void add(const FunctionVariable& computed) {
    const FieldLocation location = to_field_location(computed.location).value_or(FieldLocation::global);
    auto function = make_named_function(computed.function, scope_.definition.functions, scope_.diagnostics);
    if (!function) return;
    auto ranges = find_ranges(location);
    // Stored before the function looks for what it reads: that may be what it was before.
    const Storage values = store(computed.name, location, FieldShape::scalar, {0.0});
    auto made = make_variable_function(std::move(*function), location, variables_, scope_.diagnostics);
    if (!made || values == nullptr) return;
    compute(true,
            [made = std::move(*made), ranges = std::move(ranges), values](const OutputContext& context) {
              for (const EntityRange& range : ranges) made.evaluate(context, range, values->at(range));
            });
  }

  void add(const ComputedExpression& computed) {
    const Storage values = store(computed.name, FieldLocation::global, FieldShape::scalar, {0.0});
    if (values == nullptr) return;
    try {
      const auto expression = std::make_shared<GlobalExpression>(computed.expression, variables_);
      compute(expression->reads_all(), [expression, values](const OutputContext& context) {
        values->at(EntityRange{})[0] = expression->evaluate(context);
      });
    } catch (const ExpressionError& error) {
      scope_.diagnostics.add_error(locate(computed.expression, error.offset),
                                   fmt::format("the expression of {}: {}", computed.name.text, error.text),
                                   error.hint, error.length);
    }
  }

  void add(const VolumeAverage& average) {
    const auto selection =
        find_selection(variables_, VariableLocation::element, average.source, scope_.diagnostics);
    if (!selection) return;
    auto ranges = find_ranges(FieldLocation::element);
    const Storage values = store_like(average.name, FieldLocation::element, *selection);
    if (values == nullptr) return;
    // The points of an element share its volume equally: their average is the mean that a variable gives.
    compute(true, [selection = *selection, ranges = std::move(ranges), values](const OutputContext& context) {
      visit_values(selection, ranges, context, [&](const EntityRange& part, std::span<const double> found) {
        std::copy(found.begin(), found.end(), values->at(part).begin());
      });
    });
  }

  void add(const NodalExtrapolation& extrapolation) {
    const auto selection =
        find_selection(variables_, VariableLocation::element, extrapolation.source, scope_.diagnostics);
    if (!selection) return;
    auto ranges = find_ranges(FieldLocation::element);
    const Storage values = store_like(extrapolation.name, FieldLocation::node, *selection);
    if (values == nullptr) return;
    compute(true, [selection = *selection, ranges = std::move(ranges), values](const OutputContext& context) {
      extrapolate(selection, ranges, context, values->at({0, 0, context.model.mesh->n_nodes(), {}}));
    });
  }

  const ConditionScope& scope_;
  OutputVariables& variables_;
  UserOutputs& outputs_;
  const UserOutput* output_ = nullptr;
  ConditionLabel label_;
};

UserOutputs::UserOutputs(const ConditionScope& scope, OutputVariables& variables) {
  UserOutputMaker(scope, variables, *this).make();
}

bool UserOutputs::read_all(bool are_needed) const {
  return std::ranges::any_of(computations_, [&](const Computation& computation) {
    return computation.reads_all && (are_needed || computation.is_every_step);
  });
}

void UserOutputs::archive(StateArchive& saved) {
  for (const auto& [name, values] : stored_) {
    if (values != nullptr) values->archive("user_variables/" + name, saved);
  }
}

void UserOutputs::compute(const OutputContext& context, bool are_needed) {
  const std::int64_t step = context.state.step;
  const bool is_new = last_step_ != step, is_newly_needed = are_needed && last_needed_step_ != step;
  for (const Computation& computation : computations_) {
    if (computation.is_every_step ? is_new : is_newly_needed) computation.run(context);
  }
  last_step_ = step;
  if (are_needed) last_needed_step_ = step;
}

}  // namespace contactsim
