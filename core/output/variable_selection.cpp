// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/variable_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/threads.hpp"

namespace contactsim {

namespace {

constexpr std::string_view magnitude = "magnitude";

constexpr std::array all_locations{FieldLocation::node, FieldLocation::element, FieldLocation::global};

// Variables of Sierra/SM that no run has, or not with any material, and what others call ours.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> foreign_variables{{
    {"element_shape", "contactsim judges no element shapes"},
    {"tearing_parameter", "materials that fail have it"},
    {"temperature", "nothing is heated here"},
    {"contact_force", "here it is called force_contact"},
    {"mises", "here it is called von_mises"},
    {"peeq", "here it is called eqps"},
    {"equivalent_plastic_strain", "here it is called eqps"},
    {"effective_plastic_strain", "here it is called eqps"},
    {"plastic_strain", "here it is called eqps"},
    {"reaction_force", "here it is called reaction"},
    {"u", "here it is called displacement"},
    {"v", "here it is called velocity"},
    {"a", "here it is called acceleration"},
    {"rf", "here it is called reaction"},
}};

// What may have been meant by a name that is not known: "" when nothing comes to mind.
std::string hint_at(const OutputVariables& variables, const std::string& name,
                    std::span<const FieldLocation> locations) {
  for (const auto& [foreign, hint] : foreign_variables) {
    if (name == foreign) return std::string(hint);
  }
  for (const ForeignVariable& foreign : variables.other_names().foreign) {
    if (name == foreign.name) return fmt::format("here it is called {}", foreign.ours);
  }
  for (const OutputRow& row : element_output_rows()) {
    if (row.is_of_shells && name == row.name) return "shells have it";
    if (row.is_of_cohesive && name == row.name) return "cohesive elements have it";
  }
  std::vector<std::string> known;
  for (const FieldLocation location : locations) {
    if (const auto selection = find_by_ending(variables, location, name))
      return fmt::format("did you mean {}({})?", selection->variable->name, name.substr(name.rfind('_') + 1));
    const auto names = variables.names(location);
    known.insert(known.end(), names.begin(), names.end());
  }
  for (const OutputGroup& group : variables.other_names().groups) {
    if (std::ranges::count(locations, group.location) > 0) known.emplace_back(group.name);
  }
  return suggest(name, known);
}

// What is wrong with one reference.
class SelectionProblem {
 public:
  SelectionProblem(const VariableReference& reference, Diagnostics& diagnostics)
      : name_(reference.name), diagnostics_(diagnostics) {}

  void add(std::string text, std::string hint = "") {
    diagnostics_.add_warning("output-variable-unknown", name_.location, std::move(text), std::move(hint),
                             static_cast<int>(name_.text.size()));
  }

  void add_unknown(const OutputVariables& variables, std::optional<FieldLocation> wanted) {
    const std::string canonical = canonical_variable_name(name_.text);
    for (const FieldLocation location : all_locations) {
      if (!wanted || location == *wanted || variables.find(location, canonical) == nullptr) continue;
      add(fmt::format("'{}' is no {} variable", name_.text, to_string(*wanted)),
          fmt::format("did you mean {} {}?", to_string(location), name_.text));
      return;
    }
    for (const OutputGroup& group : variables.other_names().groups) {
      if (!wanted || group.name != canonical || group.location == *wanted) continue;
      add(fmt::format("'{}' stands for no {} variables", name_.text, to_string(*wanted)),
          fmt::format("did you mean {} {}?", to_string(group.location), name_.text));
      return;
    }
    const std::string kind = wanted ? fmt::format("{} ", to_string(*wanted)) : "";
    const auto locations = wanted ? std::span<const FieldLocation>(&*wanted, 1) : std::span(all_locations);
    add(fmt::format("no {}variable '{}' is known here", kind, name_.text),
        hint_at(variables, canonical, locations));
  }

 private:
  const DeckName& name_;
  Diagnostics& diagnostics_;
};

const OutputVariable* find_variable(const OutputVariables& variables, std::optional<FieldLocation> wanted,
                                    const std::string& name) {
  if (wanted) return variables.find(*wanted, name);
  for (const FieldLocation location : all_locations) {
    if (const OutputVariable* found = variables.find(location, name)) return found;
  }
  return nullptr;
}

std::string list_components(const OutputVariable& variable) {
  if (variable.shape == FieldShape::scalar) return "it has one component";
  std::string hint = "its components are";
  for (int c = 0; c < variable.n_components; ++c)
    hint += fmt::format(" {}", component_ending(variable.shape, c, variable.n_components));
  if (variable.shape == FieldShape::vector) hint += fmt::format(" {}", magnitude);
  return hint;
}

bool has_point(const OutputVariable& variable, const Model& model, std::size_t point) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    if (VariableSelection{&variable, {}, point}.is_in_block(model, b)) return true;
  }
  return false;
}

double length_of(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

// One piece of a range, small enough for the cache.
void fill_piece(const VariableSelection& selection, const OutputContext& context, const EntityRange& range,
                std::span<double> values) {
  if (!selection.is_one_of_several()) {
    selection.variable->fill(context, range, values);
    return;
  }
  const auto n_components = static_cast<std::size_t>(selection.variable->n_components);
  std::vector<double> all(range.count * n_components);
  selection.variable->fill(context, range, all);
  for (std::size_t i = 0; i < range.count; ++i) {
    const double* components = &all[i * n_components];
    values[i] = selection.is_magnitude ? length_of(components) : components[*selection.component];
  }
}

/// Threads share many values: calls visit(begin, count) for parts of them. What a part takes may not be
/// there: of one thread that leaves as an error.
template <class Visit>
void visit_pieces(std::size_t n, const Visit& visit) {
  constexpr std::size_t piece_size = 1024;
  const auto n_pieces = static_cast<std::ptrdiff_t>((n + piece_size - 1) / piece_size);
  parallel_for(n_pieces, threads_for(n), [&](std::ptrdiff_t p) {
    const std::size_t begin = static_cast<std::size_t>(p) * piece_size;
    visit(begin, std::min(piece_size, n - begin));
  });
}

}  // namespace

bool VariableSelection::is_in_block(const Model& model, std::size_t block) const {
  if (variable->in_blocks[block] == 0) return false;
  const std::size_t n_points = variable->is_at_points ? model.blocks[block].layout.n_points : 1;
  return !point || *point < n_points;
}

std::optional<std::size_t> find_component(const OutputVariable& variable, std::string_view text) {
  // The tensor is symmetric.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> mirrored{
      {{"yx", "xy"}, {"zy", "yz"}, {"xz", "zx"}}};
  if (variable.shape == FieldShape::symmetric_tensor) {
    for (const auto& [from, to] : mirrored) {
      if (text == from) text = to;
    }
  }
  for (int c = 0; c < variable.n_components; ++c) {
    if (text == component_ending(variable.shape, c, variable.n_components)) return c;
  }
  int number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && stop == text.data() + text.size();
  if (!is_number || number < 1 || number > variable.n_components) return std::nullopt;
  return static_cast<std::size_t>(number) - 1;
}

std::optional<VariableSelection> find_by_ending(const OutputVariables& variables, FieldLocation location,
                                                const std::string& name) {
  const std::size_t end = name.rfind('_');
  if (end == std::string::npos) return std::nullopt;
  const OutputVariable* whole = variables.find(location, canonical_variable_name(name.substr(0, end)));
  if (whole == nullptr) return std::nullopt;
  const auto component = find_component(*whole, std::string_view(name).substr(end + 1));
  if (!component) return std::nullopt;
  return VariableSelection{whole, component, {}};
}

std::optional<FieldLocation> to_field_location(VariableLocation location) {
  if (location == VariableLocation::nodal) return FieldLocation::node;
  if (location == VariableLocation::element) return FieldLocation::element;
  if (location == VariableLocation::global) return FieldLocation::global;
  return std::nullopt;
}

std::optional<VariableSelection> find_selection(const OutputVariables& variables, VariableLocation location,
                                                const VariableReference& reference,
                                                Diagnostics& diagnostics) {
  SelectionProblem problem(reference, diagnostics);
  const auto wanted = to_field_location(location);
  if (!wanted && location != VariableLocation::any) {
    problem.add(fmt::format("'{}': variables of edges, faces and sets are not written", reference.name.text));
    return std::nullopt;
  }
  VariableSelection selection;
  selection.variable = find_variable(variables, wanted, canonical_variable_name(reference.name.text));
  if (selection.variable == nullptr) {
    problem.add_unknown(variables, wanted);
    return std::nullopt;
  }
  if (!reference.component.empty()) {
    selection.is_magnitude =
        selection.variable->shape == FieldShape::vector && reference.component == magnitude;
    selection.component = find_component(*selection.variable, reference.component);
    if (!selection.is_one_of_several()) {
      problem.add(fmt::format("{} has no component '{}'", reference.name.text, reference.component),
                  list_components(*selection.variable));
      return std::nullopt;
    }
  }
  if (!reference.integration_point || selection.variable->location != FieldLocation::element)
    return selection;
  selection.point = static_cast<std::size_t>(*reference.integration_point - 1);
  if (has_point(*selection.variable, variables.model(), *selection.point)) return selection;
  problem.add(
      fmt::format("{} has no integration point {}", reference.name.text, *reference.integration_point));
  return std::nullopt;
}

void fill(const VariableSelection& selection, const OutputContext& context, const EntityRange& range,
          std::span<double> values) {
  const std::size_t n_components = selection.n_components();
  visit_pieces(range.count, [&](std::size_t begin, std::size_t count) {
    fill_piece(selection, context, {range.block, range.first + begin, count, selection.point},
               values.subspan(begin * n_components, count * n_components));
  });
}

void fill(const VariableSelection& selection, const OutputContext& context, std::size_t block,
          std::span<const std::uint32_t> entities, std::span<double> values) {
  const std::size_t n_components = selection.n_components();
  visit_pieces(entities.size(), [&](std::size_t begin, std::size_t count) {
    const std::size_t end = begin + count;
    for (std::size_t i = begin, next = begin; i < end; i = next) {
      while (next < end && entities[next] == entities[i] + (next - i)) ++next;
      fill_piece(selection, context, {block, entities[i], next - i, selection.point},
                 values.subspan(i * n_components, (next - i) * n_components));
    }
  });
}

}  // namespace contactsim
