// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_fields = 8;

using Positions = std::vector<std::size_t>;

/// The stored variable of a name of contactsim, or of a name that decks use in its place.
std::optional<Positions> find_variable(const StoredVariableKind& kind, const StoredNames& names,
                                       std::initializer_list<const char*> variables,
                                       std::size_t n_components) {
  for (const char* variable : variables) {
    for (const std::string& name : names.on_file(variable)) {
      if (auto found = find_stored(kind, name, n_components)) return found;
    }
  }
  return std::nullopt;
}

bool says(const ReportField& field, const char* word) {
  return fold(field.name).find(word) != std::string::npos || field.variable.find(word) != std::string::npos;
}

bool is_pressure(const ReportField& field) {
  return field.is_nodal && (says(field, "pressure") || says(field, "normal_traction"));
}

bool is_von_mises(const ReportField& field) { return says(field, "von_mises"); }

/// What a report is opened for comes first.
int rank_of(const ReportField& field) {
  if (is_pressure(field)) return 0;
  if (is_von_mises(field)) return 1;
  for (const char* word : {"eqps", "plastic", "damage", "slip", "traction"}) {
    if (says(field, word)) return 2;
  }
  return says(field, "velocity") || says(field, "force") ? 3 : 4;
}

std::vector<double> norm_of(const StoredVariableKind& kind, const Positions& components, std::size_t time) {
  std::vector<double> norms;
  for (const std::size_t component : components) {
    const std::vector<double> values = kind.read(component, time);
    norms.resize(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) norms[i] += values[i] * values[i];
  }
  for (double& norm : norms) norm = std::sqrt(norm);
  return norms;
}

Eigen::Matrix3Xd read_vectors(const StoredVariableKind& kind, const Positions& components, std::size_t time) {
  Eigen::Matrix3Xd vectors;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const std::vector<double> values = kind.read(components[static_cast<std::size_t>(row)], time);
    if (row == 0) vectors.resize(3, static_cast<Eigen::Index>(values.size()));
    vectors.row(row) = Eigen::Map<const Eigen::RowVectorXd>(values.data(), vectors.cols());
  }
  return vectors;
}

/// sqrt(3/2 s:s) of the deviator, by components xx yy zz xy yz zx.
std::vector<double> von_mises_of(const StoredVariableKind& kind, const Positions& stress, std::size_t time) {
  std::array<std::vector<double>, 6> s;
  for (std::size_t i = 0; i < 6; ++i) s[i] = kind.read(stress[i], time);
  std::vector<double> values(s[0].size());
  const auto square = [](double x) { return x * x; };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double normal = square(s[0][i] - s[1][i]) + square(s[1][i] - s[2][i]) + square(s[2][i] - s[0][i]);
    values[i] = std::sqrt(0.5 * normal + 3.0 * (square(s[3][i]) + square(s[4][i]) + square(s[5][i])));
  }
  return values;
}

/// Adds the fields of one kind, components joined; those in `taken` are passed over.
void add_fields(const StoredVariableKind& kind, bool is_nodal, const StoredNames& names,
                std::set<std::size_t> taken, std::vector<ReportField>& fields) {
  for (std::size_t i = 0; i < kind.names.size(); ++i) {
    const std::string& name = kind.names[i];
    if (taken.contains(i)) continue;
    const std::string base = name.size() > 2 && name.ends_with("_x") ? name.substr(0, name.size() - 2) : "";
    const auto vector = base.empty() ? std::nullopt : find_stored(kind, base, 3);
    if (!vector) {
      fields.push_back({name, names.variable_of(name), is_nodal,
                        [&kind, i](std::size_t time) { return kind.read(i, time); }});
      continue;
    }
    taken.insert(vector->begin(), vector->end());
    fields.push_back({"|" + base + "|", names.variable_of(base), is_nodal,
                      [&kind, vector](std::size_t time) { return norm_of(kind, *vector, time); }});
  }
}

void tell_missing(const StoredVariables& stored, bool moves, ReportFields& made) {
  if (stored.times.empty()) {
    made.not_found.push_back("No results over time: the mesh and its contact surfaces alone are shown.");
    return;
  }
  const auto has = [&](bool (*is)(const ReportField&)) { return std::ranges::any_of(made.fields, is); };
  if (!moves)
    made.not_found.push_back(
        "The results hold no displacement, so the mesh is drawn as it was: output nodal displacement to see "
        "it move.");
  if (!has(is_pressure))
    made.not_found.push_back(
        "The results hold no contact pressure: output nodal contact_normal_traction_magnitude as pressure to "
        "see it.");
  if (!has(is_von_mises))
    made.not_found.push_back("The results hold no von Mises stress: output element von_mises to see it.");
}

}  // namespace

ReportFields choose_report_fields(const StoredVariables& stored, const StoredNames& names) {
  ReportFields made;
  std::set<std::size_t> taken_nodal, taken_element;
  const auto displacement = find_variable(stored.nodal, names, {"displacement", "displ", "disp", "d"}, 3);
  if (displacement) {
    taken_nodal.insert(displacement->begin(), displacement->end());
    made.displacement = [&stored, displacement](std::size_t time) {
      return read_vectors(stored.nodal, *displacement, time);
    };
  }
  if (const auto stress = find_variable(stored.element, names, {"stress"}, 6)) {
    taken_element.insert(stress->begin(), stress->end());
    if (!find_variable(stored.element, names, {"von_mises"}, 1)) {
      made.fields.push_back({"von_mises", "von_mises", false, [&stored, stress](std::size_t time) {
                               return von_mises_of(stored.element, *stress, time);
                             }});
    }
  }
  if (const auto status = find_stored(stored.element, "death_status", 1))
    taken_element.insert(status->front());
  add_fields(stored.nodal, true, names, std::move(taken_nodal), made.fields);
  add_fields(stored.element, false, names, std::move(taken_element), made.fields);
  std::ranges::stable_sort(made.fields, {}, rank_of);
  tell_missing(stored, displacement.has_value(), made);
  for (std::size_t i = max_fields; i < made.fields.size(); ++i) made.left_out.push_back(made.fields[i].name);
  if (made.fields.size() > max_fields) made.fields.erase(made.fields.begin() + max_fields, made.fields.end());
  return made;
}

}  // namespace contactsim
