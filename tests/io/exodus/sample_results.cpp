// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/sample_results.hpp"

#include <string>
#include <utility>

namespace contactsim::test {

namespace {

double make_value(std::size_t field, std::size_t position, std::size_t step) {
  return static_cast<double>(field) + 1e-6 * static_cast<double>(position) +
         100.0 * static_cast<double>(step);
}

std::vector<std::string> element_variables(std::size_t first, std::size_t n, std::size_t block) {
  std::vector<std::string> names;
  for (std::size_t v = first; v < first + n; ++v) {
    names.push_back("vals_elem_var" + std::to_string(v) + "eb" + std::to_string(block + 1));
  }
  return names;
}

}  // namespace

SampleResults::SampleResults(Mesh mesh) : mesh_(std::move(mesh)) {
  add({"displ", FieldLocation::node, FieldShape::vector, 3}, mesh_.n_nodes(),
      {"vals_nod_var1", "vals_nod_var2", "vals_nod_var3"});
  add({"mass", FieldLocation::node, FieldShape::scalar, 1}, mesh_.n_nodes(), {"vals_nod_var4"});
  for (std::uint32_t b = 0; b < mesh_.blocks().size(); ++b) {
    const std::uint32_t n = mesh_.blocks()[b].n_elements;
    add({"stress", FieldLocation::element, FieldShape::symmetric_tensor, 6, b}, n,
        element_variables(1, n > 0 ? 6 : 0, b));
  }
  const auto last = static_cast<std::uint32_t>(mesh_.blocks().size()) - 1;
  add({"eqps", FieldLocation::element, FieldShape::scalar, 1, last}, mesh_.blocks()[last].n_elements,
      element_variables(7, 1, last));
  add({"kinetic_energy", FieldLocation::global, FieldShape::scalar, 1}, 1, {});
  add({"momentum", FieldLocation::global, FieldShape::vector, 3}, 1, {});
}

void SampleResults::add(OutputField field, std::size_t n_entities, std::vector<std::string> variables) {
  const std::size_t n_values = n_entities * static_cast<std::size_t>(field.n_components);
  values_.push_back({std::move(field), std::move(variables), std::vector<double>(n_values)});
}

void SampleResults::set_step(int step) {
  for (std::size_t f = 0; f < values_.size(); ++f) {
    for (std::size_t i = 0; i < values_[f].values.size(); ++i) {
      values_[f].values[i] = make_value(f, i, static_cast<std::size_t>(step));
    }
  }
}

std::vector<OutputField> SampleResults::fields() const {
  std::vector<OutputField> fields;
  for (const Values& values : values_) fields.push_back(values.field);
  return fields;
}

ResultsWriter::Values SampleResults::values() const {
  return [this](std::size_t field) { return std::span(values_[field].values); };
}

bool SampleResults::is_step(const NetcdfFile& file, std::size_t step) const {
  std::vector<double> expected_globals;
  for (std::size_t f = 0; f < values_.size(); ++f) {
    const Values& field = values_[f];
    if (field.field.location == FieldLocation::global) {
      for (std::size_t i = 0; i < field.values.size(); ++i)
        expected_globals.push_back(make_value(f, i, step));
    }
    for (std::size_t c = 0; c < field.variables.size(); ++c) {
      std::vector<double> found(field.values.size() / field.variables.size());
      file.read_double(file.find_variable(field.variables[c]).value(), {step, 1}, found);
      for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] != make_value(f, i * field.variables.size() + c, step)) return false;
      }
    }
  }
  std::vector<double> globals(expected_globals.size());
  file.read_double(file.find_variable("vals_glo_var").value(), {step, 1}, globals);
  return globals == expected_globals;
}

}  // namespace contactsim::test
