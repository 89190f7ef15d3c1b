// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/reports/run_summary.hpp"
#include "core/base/version.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

/// A number of which 0 means that it is not known.
Json positive_or_null(double value) { return value > 0.0 ? finite_or_null(value) : Json(nullptr); }

template <class T>
Json known_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string state_of(const RunSummary& summary) {
  if (!summary.exit_code) return "running";
  if (*summary.exit_code == ExitCode::done) return "done";
  return *summary.exit_code == ExitCode::stopped ? "stopped" : "failed";
}

Json mesh_json(const std::optional<SummaryMesh>& mesh) {
  if (!mesh) return nullptr;
  return {{"path", mesh->path},
          {"digest", text_or_null(mesh->digest)},
          {"nodes", known_or_null(mesh->n_nodes)},
          {"elements", known_or_null(mesh->n_elements)}};
}

Json wall_time_json(const SummaryRun& run) {
  if (!(run.seconds > 0.0)) return nullptr;
  Json parts = Json::array();
  for (const PartTime& part : run.parts)
    parts.push_back({{"name", part.name}, {"seconds", finite_or_null(part.seconds)}});
  return {{"whole", run.seconds}, {"parts", std::move(parts)}};
}

Json energies_json(const Energies& e) {
  Json json{{"kinetic", finite_or_null(e.kinetic)},
            {"internal", finite_or_null(e.internal)},
            {"external", finite_or_null(e.external)},
            {"contact", finite_or_null(e.contact)},
            {"friction", finite_or_null(e.friction)},
            {"contact_damping", finite_or_null(e.contact_damping)},
            {"contact_impact", finite_or_null(e.impact)},
            {"error", finite_or_null(e.error)},
            {"error_share", e.largest > 0.0 ? finite_or_null(e.error / e.largest) : Json(0.0)}};
  if (e.stabilization != 0.0) json["contact_stabilization"] = finite_or_null(e.stabilization);
  return json;
}

Json run_json(const SummaryRun& run) {
  return {{"steps", run.n_steps},
          {"time", finite_or_null(run.time)},
          {"termination_time", finite_or_null(run.termination_time)},
          {"ended_by", known_or_null(run.ended_by)},
          {"stable_step", positive_or_null(run.stable_step)},
          {"last_step", positive_or_null(run.last_step)},
          {"energies", energies_json(run.energies)},
          {"wall_time", wall_time_json(run)}};
}

/// The procedures that have begun before that of "run".
Json earlier_runs_json(const std::vector<SummaryRun>& runs) {
  Json all = Json::array();
  for (const SummaryRun& run : runs) all.push_back({{"procedure", run.procedure}, {"run", run_json(run)}});
  return all;
}

Json pair_json(const SummaryPair& pair) {
  const auto of_run = [&](double PairHistory::*member) {
    return pair.history ? finite_or_null((*pair.history).*member) : Json(nullptr);
  };
  return {{"number", pair.number},
          {"first", pair.first},
          {"second", pair.second},
          {"interaction", pair.interaction},
          {"line", pair.line},
          {"contact_time", of_run(&PairHistory::contact_time)},
          {"peak_force", of_run(&PairHistory::peak_force)},
          {"deepest_penetration", of_run(&PairHistory::deepest)},
          {"deepest_share", of_run(&PairHistory::deepest_share)},
          {"interpenetration", pair.interpenetration ? Json(pair.interpenetration->depth) : Json(nullptr)},
          {"passages", pair.interpenetration ? Json(pair.interpenetration->n_crossed) : Json(nullptr)},
          {"overlap_energy", pair.overlap_energy ? finite_or_null(*pair.overlap_energy) : Json(nullptr)},
          {"friction_work", of_run(&PairHistory::friction_work)}};
}

Json diagnostic_json(const Diagnostic& found) {
  const bool is_known = found.location.is_known();
  return {{"id", text_or_null(found.id)},
          {"file", is_known ? Json(found.location.file->name) : Json(nullptr)},
          {"line", is_known ? Json(found.location.line) : Json(nullptr)},
          {"column", is_known ? Json(found.location.column) : Json(nullptr)},
          {"text", found.hint.empty() ? found.text : found.text + "; " + found.hint}};
}

/// Each id once, sorted, with its count and the place and text of the first.
Json warnings_json(const Diagnostics& found) {
  std::map<std::string, Json> by_id;
  for (const Diagnostic& warning : found.all()) {
    if (warning.severity != Severity::warning) continue;
    const auto [at, is_new] = by_id.try_emplace(warning.id, nullptr);
    if (is_new) {
      Json first = diagnostic_json(warning);
      at->second = {{"id", warning.id}, {"count", 0}};
      for (const char* key : {"file", "line", "column", "text"}) at->second[key] = std::move(first[key]);
    }
    at->second["count"] = at->second["count"].get<int>() + 1;
  }
  Json warnings = Json::array();
  for (auto& [id, warning] : by_id) warnings.push_back(std::move(warning));
  return warnings;
}

Json errors_json(const RunSummary& summary) {
  Json errors = Json::array();
  for (const Diagnostic& error : summary.found.all()) {
    if (error.severity == Severity::error) errors.push_back(diagnostic_json(error));
  }
  for (const std::string& line : summary.error_lines) {
    constexpr std::string_view head = "error: ";
    Diagnostic error;
    error.text = line.starts_with(head) ? line.substr(head.size()) : line;
    errors.push_back(diagnostic_json(error));
  }
  return errors;
}

}  // namespace

std::string format_summary(const RunSummary& summary) {
  Json definitions = Json::object(), pairs = Json::array();
  for (const auto& [name, value] : summary.definitions) definitions[name] = value;
  for (const SummaryPair& pair : summary.pairs) pairs.push_back(pair_json(pair));
  Json json{{"schema", "contactsim-summary/1"},
            {"version", version},
            {"state", state_of(summary)},
            {"exit_code", summary.exit_code ? Json(static_cast<int>(*summary.exit_code)) : Json(nullptr)},
            {"stage", summary.stage},
            {"deck", {{"path", summary.deck}, {"digest", text_or_null(summary.deck_digest)}}},
            {"mesh", mesh_json(summary.mesh)},
            {"definitions", std::move(definitions)},
            {"threads", summary.n_threads},
            {"run", summary.run ? run_json(*summary.run) : Json(nullptr)},
            {"pairs", std::move(pairs)},
            {"pairs_in_all", summary.n_pairs},
            {"warnings", warnings_json(summary.found)},
            {"errors", errors_json(summary)}};
  if (!summary.earlier_runs.empty()) json["earlier_runs"] = earlier_runs_json(summary.earlier_runs);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace contactsim
