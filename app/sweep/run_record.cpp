// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/run_record.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

namespace contactsim {

namespace {

using Json = nlohmann::json;

std::optional<double> number_of(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }

void take_over_run(const Json& run, RunRecord& record) {
  record.n_steps = run.at("steps").get<std::int64_t>();
  record.time = number_of(run, "time");
  const Json& energies = run.at("energies");
  record.kinetic = number_of(energies, "kinetic");
  record.internal = number_of(energies, "internal");
  record.external = number_of(energies, "external");
  record.contact = number_of(energies, "contact");
  record.friction = number_of(energies, "friction");
  record.energy_error = number_of(energies, "error");
  record.energy_error_share = number_of(energies, "error_share");
  if (run.at("wall_time").is_object()) record.wall_time = number_of(run["wall_time"], "whole");
}

void take_over_pairs(const Json& pairs, RunRecord& record) {
  const auto raise = [](std::optional<double>& largest, const std::optional<double>& value) {
    if (value) largest = largest ? std::max(*largest, *value) : *value;
  };
  for (const Json& pair : pairs) {
    raise(record.peak_force, number_of(pair, "peak_force"));
    raise(record.deepest, number_of(pair, "deepest_penetration"));
    raise(record.deepest_share, number_of(pair, "deepest_share"));
  }
}

RunRecord record_of(const Json& summary) {
  RunRecord record;
  record.state = summary.at("state").get<std::string>();
  if (record.state == "running") record.state = "not ended";
  if (const Json& code = summary.at("exit_code"); code.is_number())
    record.exit_code = code.get<std::int64_t>();
  record.deck_digest = text_of(summary.at("deck").at("digest"));
  if (summary.at("mesh").is_object()) record.mesh_digest = text_of(summary["mesh"].at("digest"));
  if (summary.at("run").is_object()) take_over_run(summary["run"], record);
  take_over_pairs(summary.at("pairs"), record);
  for (const Json& warning : summary.at("warnings")) {
    record.n_warnings += warning.at("count").get<std::int64_t>();
    if (warning.at("id") == "aprepro-unused") record.unused = text_of(warning.at("text"));
  }
  const Json& errors = summary.at("errors");
  record.n_errors = static_cast<std::int64_t>(errors.size());
  if (!errors.empty()) record.first_error = text_of(errors[0].at("text"));
  return record;
}

}  // namespace

std::optional<RunRecord> read_record(const std::string& folder, const SweepPoint& point) {
  std::ifstream file(folder + "/" + summary_name, std::ios::binary);
  if (!file) return std::nullopt;
  try {
    const Json summary = Json::parse(file);
    const auto definitions = summary.at("definitions").get<std::map<std::string, std::string>>();
    if (definitions != std::map<std::string, std::string>(point.begin(), point.end())) return std::nullopt;
    return record_of(summary);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace contactsim
