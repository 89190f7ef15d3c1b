// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/report_file.hpp"

#include <filesystem>
#include <fstream>
#include <string_view>

#include "app/cli/run_mesh.hpp"
#include "app/compare/compare_files.hpp"
#include "app/report/results_mesh.hpp"
#include "app/report/write_report.hpp"
#include "core/base/errors.hpp"
#include "core/elements/cohesive_section.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

/// Whether a file is netCDF, by its first bytes.
bool is_netcdf(const std::string& path) {
  char head[4] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  const std::string_view read(head, sizeof head);
  return read.starts_with("CDF") || read.substr(1) == "HDF";
}

/// The first output of the run that holds its mesh.
std::optional<Mesh> find_results(const ReportDraft& draft) {
  for (const std::string& path : draft.output_paths) {
    if (!is_netcdf(path)) continue;
    Diagnostics discarded;
    try {
      Mesh mesh = read_results_mesh(path, discarded);
      if (mesh.n_nodes() > 0) return mesh;
    } catch (const FileError&) {
      // Values over time without a mesh.
    }
  }
  return std::nullopt;
}

void add_mesh(const Options& options, const ReportDraft& draft, ReportRun& run) {
  if (!draft.region) return;
  const ReportRegion region{*draft.definition, *draft.region};
  std::optional<Mesh> mesh = find_results(draft);
  if (mesh) run.name = mesh->path();
  if (!mesh && options.stage == Stage::run)
    run.notes.push_back(
        "The run has written no results over time: BEGIN RESULTS OUTPUT in the region would show how it "
        "moves.");
  if (!mesh) {
    if (!draft.has_mesh) return;
    Diagnostics discarded;
    mesh = read_run_mesh(options, region.definition, region.region, discarded);
  }
  const std::string path = mesh->path();
  mesh = with_cohesive_blocks(region.definition, region.region, std::move(*mesh));
  try {
    run.mesh = make_report_mesh(path, *mesh, region);
  } catch (const DeckError&) {  // which the run has reported
    run.mesh = make_report_mesh(path, *mesh, std::nullopt);
  }
}

void add_charts(const ReportDraft& draft, ReportRun& run) {
  run.charts = draft.curves.charts();
  for (const std::string& path : draft.output_paths) {
    std::error_code ignored;
    if (is_netcdf(path) || !fs::is_regular_file(path, ignored)) continue;
    try {
      const ComparedFile file = read_compared_file(path);
      if (file.kind != InputKind::heartbeat) continue;
      for (CurveChart& chart : make_charts(read_heartbeat_columns(path, file.text)))
        run.charts.push_back(std::move(chart));
    } catch (const FileError&) {
      run.notes.push_back("The heartbeat " + path + " is not shown: it is no CSV (FORMAT = CSV is).");
    }
  }
}

}  // namespace

std::optional<PageLibraries> find_report_libraries(const Options& options) {
  if (!options.report) return std::nullopt;
  check_report_place(*options.report);
  if (const std::string obstacle = find_write_obstacle(*options.report); !obstacle.empty())
    throw FileError(*options.report, obstacle);
  return read_page_libraries();
}

void write_report_file(const Options& options, const ReportDraft& draft, const RunSummary& summary,
                       const PageLibraries& libraries) {
  ReportRun run;
  run.name = options.deck;
  run.deck = draft.deck;
  run.summary = format_summary(summary);
  run.has_surface_lines = draft.deck.size() == 1;  // else they may be of an include
  run.surfaces = draft.surfaces;
  run.found = summary.found;
  for (const std::string& line : summary.error_lines) {
    constexpr std::string_view head = "error: ";
    run.found.add_error({}, line.starts_with(head) ? line.substr(head.size()) : line);
  }
  if (draft.definition) run.title = title_of(*draft.definition);
  add_charts(draft, run);
  add_mesh(options, draft, run);
  std::vector<ReportRun> runs;
  runs.push_back(std::move(run));
  write_report(*options.report, runs, libraries);
}

}  // namespace contactsim
