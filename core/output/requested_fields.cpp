// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/requested_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "core/output/output_groups.hpp"

namespace contactsim {

namespace {

std::size_t count_entities(const VariableSelection& selection, const Model& model, std::size_t block) {
  if (selection.variable->location == FieldLocation::node) return model.mesh->n_nodes();
  return selection.variable->location == FieldLocation::global ? 1 : model.blocks[block].n_elements;
}

bool is_named(std::span<const DeckName> names, const std::vector<std::string>& block_names) {
  return std::any_of(names.begin(), names.end(), [&](const DeckName& name) {
    return std::any_of(block_names.begin(), block_names.end(),
                       [&](const std::string& own) { return fold(own) == fold(name.text); });
  });
}

class FieldMaker {
 public:
  FieldMaker(const OutputVariables& variables, const FieldRequests& requests,
             std::span<const std::vector<std::string>> block_names, Diagnostics& diagnostics)
      : variables_(variables), requests_(requests), block_names_(block_names), diagnostics_(diagnostics) {}

  std::vector<RequestedFields::Field> make() {
    check_blocks(requests_.included);
    check_blocks(requests_.excluded);
    for (const VariableRequest& request : expand_groups(variables_, requests_.variables, diagnostics_))
      add_request(request);
    for (const OutputRow& row : global_output_rows()) {
      if (row.is_always_written) add_unasked(std::string(row.name));
    }
    return std::move(fields_);
  }

 private:
  // A field is known to a file by where it is and its name without regard to case.
  using Key = std::tuple<FieldLocation, std::size_t, std::string>;

  void warn(std::string_view id, const DeckName& at, std::string text, std::string hint = "") {
    diagnostics_.add_warning(id, at.location, std::move(text), std::move(hint),
                             static_cast<int>(at.text.size()));
  }

  void add_unasked(const std::string& name) {
    const VariableSelection selection{variables_.find(FieldLocation::global, name), {}, {}};
    const bool is_taken = names_.count({FieldLocation::global, 0, name}) != 0 ||
                          columns_.count({FieldLocation::global, 0, name}) != 0;
    if (!is_taken) add_field(selection, {}, name);
  }

  void check_blocks(std::span<const DeckName> names) {
    std::vector<std::string> known;
    for (const auto& names_of_block : block_names_)
      known.insert(known.end(), names_of_block.begin(), names_of_block.end());
    for (const DeckName& name : names) {
      const bool is_known = std::any_of(known.begin(), known.end(),
                                        [&](const auto& own) { return fold(own) == fold(name.text); });
      if (!is_known)
        warn("output-part-unknown", name, fmt::format("'{}' is no block of the mesh", name.text),
             suggest(name.text, known));
    }
  }

  void add_request(const VariableRequest& request) {
    const auto selection = find_selection(variables_, request.location, request.variable, diagnostics_);
    if (!selection) return;
    const std::string name = field_name(request, *selection, requests_.separator);
    const auto* parts = std::get_if<NamedParts>(&request.place);
    if (selection->variable->location == FieldLocation::element) {
      if (parts != nullptr) check_blocks(parts->names);
      add_element_fields(request, *selection, name);
      return;
    }
    if (parts != nullptr)
      warn("output-part-whole", request.variable.name,
           fmt::format("{} is written for the whole model: parts are for element variables", name));
    if (is_free(*selection, 0, name, request.variable.name)) add_field(*selection, {}, name);
  }

  void add_element_fields(const VariableRequest& request, const VariableSelection& selection,
                          const std::string& name) {
    const Model& model = variables_.model();
    bool is_anywhere = false;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
      if (!selection.is_in_block(model, b) || !is_covered(request, model.blocks[b].mesh_block)) continue;
      is_anywhere = true;
      if (!is_free(selection, b, name, request.variable.name)) return;
      add_field(selection, {b, 0, 1, {}}, name);
    }
    if (!is_anywhere)
      warn("output-part-none", request.variable.name, fmt::format("no block that is asked for has {}", name));
  }

  bool is_covered(const VariableRequest& request, std::uint32_t mesh_block) const {
    const std::vector<std::string>& names = block_names_[mesh_block];
    const auto* parts = std::get_if<NamedParts>(&request.place);
    if (parts != nullptr && is_named(parts->names, names) == parts->are_excluded) return false;
    if (!requests_.included.empty() && !is_named(requests_.included, names)) return false;
    return !is_named(requests_.excluded, names);
  }

  bool is_free(const VariableSelection& selection, std::size_t block, const std::string& name,
               const DeckName& at) {
    if (names_.count({selection.variable->location, block, fold(name)}) == 0)
      return !has_taken_component(selection, block, name, at);
    warn("output-name-taken", at,
         fmt::format("a {} variable {} is on the file already: this one is left out",
                     to_string(selection.variable->location), name),
         "an alias gives it another name: AS <alias>");
    return false;
  }

  /// Whether a component would have the name of another field's: a file cannot hold both.
  bool has_taken_component(const VariableSelection& selection, std::size_t block, const std::string& name,
                           const DeckName& at) {
    const OutputField field = describe(selection, {block, 0, 1, {}}, name).field;
    for (int c = 0; c < field.n_components; ++c) {
      const auto found = columns_.find({field.location, block, fold(component_name(field, c))});
      if (found == columns_.end()) continue;
      diagnostics_.add_error(
          at.location,
          fmt::format("{} variable {}: the file has {} of the variable {} already", to_string(field.location),
                      name, component_name(field, c), found->second),
          "leave one of them out, or give it another name: AS <alias>", static_cast<int>(at.text.size()));
      return true;
    }
    return false;
  }

  RequestedFields::Field describe(const VariableSelection& selection, const EntityRange& range,
                                  const std::string& name) const {
    RequestedFields::Field made = make_field(selection, variables_.model(), range, name);
    made.field.separator = requests_.separator;
    return made;
  }

  void add_field(const VariableSelection& selection, EntityRange range, const std::string& name) {
    const Model& model = variables_.model();
    names_.insert({selection.variable->location, range.block, fold(name)});
    range.count = count_entities(selection, model, range.block);
    fields_.push_back(describe(selection, range, name));
    const OutputField& field = fields_.back().field;
    for (int c = 0; c < field.n_components; ++c)
      columns_.try_emplace({field.location, range.block, fold(component_name(field, c))}, name);
  }

  const OutputVariables& variables_;
  const FieldRequests& requests_;
  std::span<const std::vector<std::string>> block_names_;
  Diagnostics& diagnostics_;
  std::set<Key> names_;
  std::map<Key, std::string> columns_;  ///< names of components, with those of their fields
  std::vector<RequestedFields::Field> fields_;
};

}  // namespace

RequestedFields::Field make_field(const VariableSelection& selection, const Model& model,
                                  const EntityRange& range, const std::string& name) {
  RequestedFields::Field made;
  made.selection = selection;
  made.range = range;
  made.field.name = name;
  made.field.location = selection.variable->location;
  made.field.shape = selection.is_one_of_several() ? FieldShape::scalar : selection.variable->shape;
  made.field.n_components = static_cast<int>(selection.n_components());
  if (made.field.location == FieldLocation::element) made.field.block = model.blocks[range.block].mesh_block;
  return made;
}

std::string field_name(const VariableRequest& request, const VariableSelection& selection,
                       const std::string& separator) {
  if (!request.alias.empty()) return request.alias;
  std::string name = request.variable.name.text;
  if (selection.point) name += fmt::format("{}{}", separator, *selection.point + 1);
  if (selection.is_magnitude) return with_ending(name, separator, "magnitude");
  if (!selection.component) return name;
  const OutputVariable& variable = *selection.variable;
  return with_ending(
      name, separator,
      component_ending(variable.shape, static_cast<int>(*selection.component), variable.n_components));
}

std::vector<OutputField> RequestedFields::fields() const {
  std::vector<OutputField> fields;
  for (const Field& field : fields_) fields.push_back(field.field);
  return fields;
}

bool RequestedFields::read_all() const {
  return std::ranges::any_of(fields_, [](const Field& field) { return field.selection.variable->reads_all; });
}

std::span<const double> RequestedFields::evaluate(std::size_t field, const OutputContext& context) {
  const auto& [selection, range, description] = fields_[field];
  values_.resize(range.count * selection.n_components());
  fill(selection, context, range, values_);
  return values_;
}

std::span<const double> RequestedFields::evaluate(std::size_t field, const OutputContext& context,
                                                  const MeshPiece& piece) {
  const auto& [selection, range, description] = fields_[field];
  if (description.location == FieldLocation::global) return evaluate(field, context);
  std::span<const std::uint32_t> entities = piece.entities(description);
  if (description.location == FieldLocation::node) {
    // Nodes that results add to the mesh are the last of files.
    const auto end = std::ranges::partition_point(
        entities, [n = context.model.mesh->n_nodes()](std::uint32_t node) { return node < n; });
    entities = {entities.begin(), end};
  }
  values_.resize(entities.size() * selection.n_components());
  fill(selection, context, range.block, entities, values_);
  return values_;
}

RequestedFields make_requested_fields(const OutputVariables& variables, const FieldRequests& requests,
                                      std::span<const std::vector<std::string>> block_names,
                                      Diagnostics& diagnostics) {
  return RequestedFields(FieldMaker(variables, requests, block_names, diagnostics).make());
}

}  // namespace contactsim
