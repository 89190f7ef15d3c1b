// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "app/cli/read_run_deck.hpp"
#include "app/compare/compare_files.hpp"
#include "app/report/results_mesh.hpp"
#include "app/report/write_report.hpp"
#include "app/reports/surface_report.hpp"
#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_summary.hpp"
#include "core/base/errors.hpp"
#include "core/elements/cohesive_section.hpp"
#include "io/exodus/run_records.hpp"
#include "io/pieces/piece_files.hpp"
#include "parser/deck.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

/// The deck that a run stored in its results: what Aprepro made of it, behind the command line.
std::string stored_deck(const std::string& results) {
  const std::vector<std::string> lines = read_info_lines(results);
  std::string text;
  for (std::size_t i = 1; i < lines.size(); ++i) text += lines[i] + "\n";
  return text;
}

/// The name of results with another extension; of pieces it is that of the whole.
fs::path name_beside(const std::string& results, const char* extension) {
  const auto pieces = parse_piece_path(results);
  return fs::path(pieces ? pieces->base : results).replace_extension(extension);
}

/// The file of a name beside another, if it is there and of that kind.
std::optional<ComparedFile> find_beside(const std::string& results, const char* extension, InputKind kind) {
  const fs::path path = name_beside(results, extension);
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    ComparedFile file = read_compared_file(path.string());
    if (file.kind == kind) return file;
  } catch (const FileError&) {
    // Something else that has the name.
  }
  return std::nullopt;
}

ComparedFile read_of_kind(const std::string& path, InputKind kind) {
  ComparedFile file = read_compared_file(path);
  if (file.kind != kind)
    throw FileError(path, "expected " + describe(kind) + ", found " + describe(file.kind));
  return file;
}

void add_summary(const std::string& results, const ReportOptions& options, ReportRun& run) {
  if (options.summary) {
    run.summary = read_of_kind(*options.summary, InputKind::summary).text;
  } else if (auto file = find_beside(results, ".json", InputKind::summary)) {
    run.summary = std::move(file->text);
  } else {
    run.notes.push_back(
        "There is no summary beside the results, so it is not known how the run ended, what its pairs did "
        "and "
        "what was warned of: run with --summary, or with --report.");
  }
}

void add_charts(const std::string& results, const ReportOptions& options, ReportRun& run) {
  const auto add = [&](const ColumnTable& table) {
    for (CurveChart& chart : make_charts(table)) run.charts.push_back(std::move(chart));
  };
  add(read_global_columns(results));
  for (const std::string& path : options.heartbeats)
    add(read_heartbeat_columns(path, read_of_kind(path, InputKind::heartbeat).text));
  if (!options.heartbeats.empty()) return;
  if (const auto file = find_beside(results, ".csv", InputKind::heartbeat))
    add(read_heartbeat_columns(file->path, file->text));
}

/// Resolves the surfaces by the deck; notes when that does not work.
void add_mesh(const std::string& results, const std::string& deck, ReportRun& run) {
  Diagnostics found;
  const Mesh mesh = read_results_mesh(results, found);
  try {
    if (deck.empty()) {
      run.notes.push_back("The results hold no deck: owners are those of the side sets contact_<surface>.");
    } else {
      const auto definition = parse_deck_text(run.name, deck, {{}, true}, found);
      stop_on_errors(found);
      run.title = title_of(definition);
      const Region region = choose_region(definition, true, found).region;
      const Mesh meant = with_cohesive_blocks(definition, region, mesh);
      if (region.contact) {
        const ContactModel model = make_contact_model(definition, region, meant, found);
        stop_on_errors(found);
        run.surfaces = format_surfaces_json(model, summarize(model, meant));
      }
      run.mesh = make_report_mesh(results, meant, ReportRegion{definition, region});
      return;
    }
  } catch (const DeckError& error) {
    run.notes.push_back(
        fmt::format("The deck in the results does not fit their mesh ({}): owners are those of the side sets "
                    "contact_<surface>.",
                    error.diagnostics().all().front().text));
    run.surfaces.clear();
  }
  run.mesh = make_report_mesh(results, mesh, std::nullopt);
}

}  // namespace

ReportRun read_report_run(const std::string& results, const ReportOptions& options) {
  ReportRun run;
  run.name = results;
  const std::string deck = stored_deck(results);
  if (options.deck) {
    const ComparedFile file = read_of_kind(*options.deck, InputKind::deck);
    run.deck.push_back({file.path, file.text});
  } else if (!deck.empty()) {
    run.deck.push_back({"deck in " + results, deck});
    run.is_deck_expanded = true;
    run.has_surface_lines = true;
  }
  add_summary(results, options, run);
  add_charts(results, options, run);
  add_mesh(results, deck, run);
  return run;
}

int run_report(const ReportOptions& options) {
  const PageLibraries libraries = read_page_libraries();
  std::vector<ReportRun> runs;
  for (const std::string& results : options.results) runs.push_back(read_report_run(results, options));
  const std::string path = options.output.value_or(name_beside(options.results.front(), ".html").string());
  write_report(path, runs, libraries);
  std::printf("%s, %ju bytes\n", path.c_str(), static_cast<std::uintmax_t>(fs::file_size(path)));
  return static_cast<int>(ExitCode::done);
}

}  // namespace contactsim
