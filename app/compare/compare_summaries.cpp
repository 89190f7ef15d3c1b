// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_summaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;
/// Values of a summary by their names, such as "run.steps".
using NamedValues = std::map<std::string, Json>;

void add_values(const std::string& name, const Json& json, NamedValues& values) {
  if (!json.is_object()) {
    values[name] = json;
    return;
  }
  for (const auto& [key, value] : json.items())
    add_values(name.empty() ? key : name + "." + key, value, values);
}

std::string pair_name(const Json& pair) {
  return fmt::format("pair {} - {} ({})", pair.at("first").get<std::string>(),
                     pair.at("second").get<std::string>(), pair.at("interaction").get<std::string>());
}

/// All that counts when summaries are compared. What one may lack as a whole, a pair or the run, has a value
/// of its own.
NamedValues list_values(const Json& summary) {
  NamedValues values;
  for (const char* key : {"state", "exit_code", "stage", "definitions", "pairs_in_all"})
    add_values(key, summary.at(key), values);
  if (Json run = summary.at("run"); run.is_object()) {
    run.erase("wall_time");
    run.at("energies").erase("error_share");  // a ratio of two others
    values["run"] = "present";
    add_values("run", run, values);
  }
  if (const Json& mesh = summary.at("mesh"); mesh.is_object()) {
    values["mesh.nodes"] = mesh.at("nodes");
    values["mesh.elements"] = mesh.at("elements");
  }
  for (const Json& pair : summary.at("pairs")) {
    Json numbers = pair;
    for (const char* key : {"number", "first", "second", "interaction", "line"}) numbers.erase(key);
    values[pair_name(pair)] = "present";
    add_values(pair_name(pair), numbers, values);
  }
  for (const Json& warning : summary.at("warnings"))
    values["warning " + warning.at("id").get<std::string>()] = warning.at("count");
  int n_errors = 0;
  for (const Json& error : summary.at("errors"))
    values[fmt::format("error {}", ++n_errors)] = error.at("text");
  return values;
}

NamedValues read_values(const SummaryText& file) {
  try {
    return list_values(Json::parse(file.text));
  } catch (const Json::exception& error) {
    throw FileError(file.path, fmt::format("no summary as --summary writes it ({})", error.what()));
  }
}

bool is_energy(const std::string& name) { return name.starts_with("run.energies."); }

/// The largest energy of both.
double energy_scale(const NamedValues& first, const NamedValues& second) {
  double scale = 0.0;
  for (const NamedValues* values : {&first, &second}) {
    for (const auto& [name, value] : *values) {
      if (is_energy(name) && value.is_number()) scale = std::max(scale, std::abs(value.get<double>()));
    }
  }
  return scale;
}

bool is_different(const std::string& name, const Json& a, const Json& b, const Tolerance& tolerance,
                  double of_energies) {
  if (!a.is_number() || !b.is_number()) return a != b;
  const double x = a.get<double>(), y = b.get<double>();
  return is_energy(name) ? tolerance.is_exceeded(x, y, of_energies) : tolerance.is_exceeded(x, y);
}

std::string show(const Json& value) {
  if (value.is_number_float()) return format_value(value.get<double>());
  return value.is_string() ? "'" + value.get<std::string>() + "'" : value.dump();
}

Difference::Value field_of(const Json& value) {
  if (value.is_number()) return value.get<double>();
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Difference describe_values(const std::string& name, const Json& a, const Json& b) {
  Difference difference{"value",
                        fmt::format("{}: {} -> {}", name, show(a), show(b)),
                        {{"name", name}, {"first", field_of(a)}, {"second", field_of(b)}}};
  if (a.is_number() && b.is_number()) {
    const double by = b.get<double>() - a.get<double>();
    difference.text += fmt::format(", by {:.3g}", by);
    difference.fields.emplace_back("difference", by);
  }
  return difference;
}

/// Leaves out what one has that the other lacks as a whole, but for the line that says so.
void drop_parts_of_absent(NamedValues& values, const NamedValues& others) {
  for (auto at = values.begin(); at != values.end();) {
    const std::string name = at++->first;
    if (values[name] != "present" || others.contains(name)) continue;
    while (at != values.end() && at->first.starts_with(name + ".")) at = values.erase(at);
  }
}

}  // namespace

std::vector<Difference> compare_summaries(const SummaryText& first, const SummaryText& second,
                                          const Tolerance& tolerance) {
  NamedValues a = read_values(first), b = read_values(second);
  drop_parts_of_absent(a, b);
  drop_parts_of_absent(b, a);
  for (const auto& [name, value] : a) b.try_emplace(name, "absent");
  for (const auto& [name, value] : b) a.try_emplace(name, "absent");
  const double of_energies = energy_scale(a, b);
  std::vector<Difference> differences;
  for (const auto& [name, value] : a) {
    if (is_different(name, value, b[name], tolerance, of_energies))
      differences.push_back(describe_values(name, value, b[name]));
  }
  return differences;
}

}  // namespace contactsim
