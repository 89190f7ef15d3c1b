// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_summary.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "contact/enforcement/contact_force.hpp"
#include "core/base/digest.hpp"
#include "core/definition/procedure.hpp"

namespace contactsim {

namespace {

/// General contact of a thousand blocks makes half a million pairs, of which few touch.
constexpr std::size_t max_idle_pairs = 1000;

SummaryPair name_pair(const ContactModel& model, PairIndex i) {
  const SurfacePair& pair = model.pairs[i];
  return {static_cast<std::uint32_t>(i.value + 1),
          model.surfaces.surfaces[pair.first].name,
          model.surfaces.surfaces[pair.second].name,
          pair.interaction,
          pair.location.line,
          std::nullopt};
}

}  // namespace

std::string format_digest(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

std::string digest_of_files(std::span<const std::string> paths) {
  std::vector<char> bytes(std::size_t{1} << 20);
  Digest digest;
  for (const std::string& path : paths) {
    std::ifstream file(path, std::ios::binary);
    while (file) {
      file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      digest.add_values(std::span<const char>(bytes.data(), static_cast<std::size_t>(file.gcount())));
    }
    if (!file.eof()) return "";
  }
  return format_digest(digest.value());
}

void note_pairs(const ContactModel& model, RunSummary& summary) {
  summary.pairs.clear();
  summary.n_pairs = model.pairs.size();
  for (const PairIndex i : indices(model.pairs)) {
    if (summary.pairs.size() == max_idle_pairs) return;
    summary.pairs.push_back(name_pair(model, i));
  }
}

void note_run(const Simulation& run, RunSummary& summary) {
  const State& state = run.state();
  SummaryRun& noted = summary.run.emplace();
  noted.procedure = run.procedure().name.text;
  noted.n_steps = state.step;
  noted.time = state.time;
  noted.termination_time = run.control().termination_time();
  noted.stable_step = run.start_report().stable_step;
  noted.last_step = state.dt;
  noted.energies = state.energies;
  noted.ended_by = run.stopped_by();
  if (!noted.ended_by && run.end()) noted.ended_by = run.end()->reason;
  noted.seconds = run.seconds();
  if (noted.seconds > 0.0) noted.parts = run.part_times();
  if (run.contact_force() == nullptr) return;
  const ContactModel& model = *run.contact_model();
  const auto histories = run.contact_force()->histories();
  const auto found = run.interpenetrations();
  summary.pairs.clear();
  summary.n_pairs = model.pairs.size();
  std::size_t n_idle = 0;
  for (const PairIndex i : indices(model.pairs)) {
    const bool is_idle = !histories[i].has_touched() && found[i].depth == 0.0 && found[i].n_crossed == 0;
    if (is_idle && ++n_idle > max_idle_pairs) continue;
    summary.pairs.push_back(name_pair(model, i));
    summary.pairs.back().history = histories[i];
    summary.pairs.back().interpenetration = found[i];
    summary.pairs.back().overlap_energy =
        histories[i].stored_at_start + run.contact_force()->recovery_energy().of_overlaps(i);
  }
}

}  // namespace contactsim
