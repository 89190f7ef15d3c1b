// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <variant>

#include "core/base/digest.hpp"
#include "core/definition/simulation.hpp"
#include "core/elements/element_table.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// Something with a number that a run of other contents does not have.
class Fingerprint {
 public:
  void add(std::string_view text) {
    digest_.add_values(std::span<const char>(text));
    digest_.add_values(std::span<const char>("\n", 1));
  }
  void add(double number) { digest_.add_values(std::span<const double>(&number, 1)); }
  void add(const std::vector<Lanes>& numbers) {
    for (const Lanes& batch : numbers) digest_.add_values(std::span<const double>(batch.data(), n_lanes));
  }
  std::uint64_t value() const { return digest_.value(); }

 private:
  Digest digest_;
};

void add_function(const FunctionDefinition& function, Fingerprint& print) {
  for (const double number : {function.x_scale, function.x_offset, function.y_scale, function.y_offset})
    print.add(number);
  for (const FunctionValue& value : function.values) {
    print.add(value.abscissa);
    print.add(value.ordinate);
    for (const double number : value.further) print.add(number);
    print.add(value.expression);
  }
}

/// The values of a law that are set, and of the functions that it names.
void add_values(const SimulationDefinition& definition, const ParameterValues& values, Fingerprint& print) {
  for (const Parameter& parameter : values.parameters()) {
    if (!values.has(parameter.phrase)) continue;
    print.add(parameter.phrase);
    const ParameterValue& value = values.at(parameter.phrase);
    if (const auto* real = std::get_if<double>(&value)) print.add(*real);
    if (const auto* count = std::get_if<std::int64_t>(&value)) print.add(static_cast<double>(*count));
    const auto* name = std::get_if<DeckName>(&value);
    if (name == nullptr) continue;
    print.add(name->text);
    const FunctionDefinition* function =
        parameter.kind == ParameterKind::function ? find_by_name(definition.functions, name->text) : nullptr;
    if (function != nullptr) add_function(*function, print);
  }
}

RunMark mark_of(const SimulationDefinition& definition, const MaterialDefinition& material) {
  Fingerprint print;
  print.add(material.density);
  for (const MaterialModel& model : material.models) {
    print.add(model.name.text);
    add_values(definition, model.values, print);
  }
  return {fmt::format("the material '{}'", material.name.text), material.name.location, print.value()};
}

RunMark mark_of(const Model& model, const ModelBlock& block, const DeckLocation& location) {
  Fingerprint print;
  print.add(block.element->formulation);
  print.add(block.thickness);
  print.add(block.section);
  return {fmt::format("the section of block '{}'", model.mesh->name({EntityKind::block, block.mesh_block})),
          location, print.value()};
}

RunMark mark_of(const SimulationDefinition& definition, const ContactModel& contact,
                const SurfacePair& pair) {
  Fingerprint print;
  print.add(pair.law->type);
  add_values(definition, pair.law->values, print);
  print.add(static_cast<double>(pair.formulation));
  print.add(static_cast<double>(pair.enforcement));
  print.add(pair.penalty_scale);
  print.add(pair.penalty_stiffness.value_or(0.0));
  print.add(pair.damping_fraction);
  const auto& surfaces = contact.surfaces.surfaces;
  return {fmt::format("the contact of '{}' and '{}'", surfaces[pair.first].name, surfaces[pair.second].name),
          pair.location, print.value()};
}

/// Fingerprints as numbers that a double holds exactly.
struct SavedMark {
  double what = 0.0, digest = 0.0;
};

double as_number(std::uint64_t digest) {
  constexpr int n_surplus_bits = 64 - std::numeric_limits<double>::digits;
  return static_cast<double>(digest >> n_surplus_bits);
}

SavedMark as_saved(const RunMark& mark) { return {as_number(digest_of(mark.what)), as_number(mark.digest)}; }

}  // namespace

std::vector<RunMark> find_run_marks(const RunInput& input, const Model& model) {
  std::vector<RunMark> marks;
  for (const MaterialDefinition& material : input.definition.materials)
    marks.push_back(mark_of(input.definition, material));
  for (const ModelBlock& block : model.blocks)
    marks.push_back(mark_of(model, block, input.region.name.location));
  if (input.contact == nullptr) return marks;
  for (const SurfacePair& pair : input.contact->pairs)
    marks.push_back(mark_of(input.definition, *input.contact, pair));
  return marks;
}

std::vector<RunMark> archive(const std::vector<RunMark>& marks, StateArchive& saved) {
  const char* name = "run/marks";
  std::vector<RunMark> changed;
  if (!saved.has(name)) return changed;
  std::vector<SavedMark> kept;
  for (const RunMark& mark : marks) kept.push_back(as_saved(mark));
  saved.rows(name, kept, [](SavedMark& one, RowNumbers& row) { row(one.what, one.digest); });
  if (!saved.restores()) return changed;
  std::ranges::copy_if(marks, std::back_inserter(changed), [&](const RunMark& mark) {
    const SavedMark now = as_saved(mark);
    // Pairs of the same surfaces take turns: several marks may be of the same.
    const auto is_of_it = [&](const SavedMark& before) { return before.what == now.what; };
    const auto is_it = [&](const SavedMark& before) {
      return is_of_it(before) && before.digest == now.digest;
    };
    return std::ranges::any_of(kept, is_of_it) && std::ranges::none_of(kept, is_it);
  });
  return changed;
}

}  // namespace contactsim
