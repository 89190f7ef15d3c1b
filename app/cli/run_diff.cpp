// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_diff.hpp"

#include <cstdio>
#include <exception>
#include <optional>

#include "app/cli/read_run_deck.hpp"
#include "app/cli/run_mesh.hpp"
#include "app/compare/compare_files.hpp"
#include "app/compare/compare_ownership.hpp"
#include "app/compare/ownership_table.hpp"
#include "app/reports/surface_report.hpp"
#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_summary.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

namespace {

constexpr int same = 0, different = 1, unreadable = 2;

/// The surfaces of a deck on a mesh, without a run. Throws DeckError, FileError.
OwnershipTable resolve_table(const DeckRequest& request, const std::optional<std::string>& mesh_path) {
  Diagnostics found;
  const RunDeck deck = read_run_deck(request, found);
  stop_on_errors(found);
  const Region region = choose_region(deck.definition, true, found).region;
  if (!region.contact) throw FileError(request.path, "the deck has no contact definition");
  Options options;
  options.deck = request.path;
  options.mesh = mesh_path;
  const Mesh mesh = read_run_mesh(options, deck.definition, region, found);
  const ContactModel model = make_contact_model(deck.definition, region, mesh, found);
  stop_on_errors(found);
  OwnershipTable table;
  read_surfaces_json(request.path, format_surfaces_json(model, summarize(model, mesh)), table);
  read_surfaces_csv(request.path, format_surfaces_csv(model, list_facets(model, mesh)), table);
  return table;
}

/// A deck, with the definitions that are its own.
DeckRequest deck_request(const DiffOptions& options, std::size_t which) {
  DeckRequest request;
  request.path = which == 0 ? options.first : options.second;
  request.definitions = options.definitions;
  request.is_lenient = options.is_lenient;
  const auto& own = which == 0 ? options.first_definitions : options.second_definitions;
  request.definitions.insert(request.definitions.end(), own.begin(), own.end());
  return request;
}

FileComparison compare_decks(const DiffOptions& options) {
  const OwnershipTable first = resolve_table(deck_request(options, 0), options.mesh);
  const OwnershipTable second = resolve_table(deck_request(options, 1), options.mesh);
  return {"ownership", options.first, options.second,
          compare_ownership(first, second, options.tolerance, options.lists_faces)};
}

FileComparison compare(const DiffOptions& options) {
  const ComparedFile first = read_compared_file(options.first);
  const ComparedFile second = read_compared_file(options.second);
  if (first.kind == InputKind::deck && second.kind == InputKind::deck) return compare_decks(options);
  if (options.mesh)
    throw FileError(*options.mesh, "a mesh is for two decks, but " + options.first + " is " +
                                       describe(first.kind) + " and " + options.second + " is " +
                                       describe(second.kind));
  return compare_files(first, second, {options.tolerance, options.lists_faces});
}

void print_errors(const Diagnostics& diagnostics) {
  for (const DiagnosticGroup& group : diagnostics.grouped()) {
    if (group.first.severity == Severity::error) std::fputs(format_machine(group).c_str(), stderr);
  }
}

}  // namespace

int run_diff(const DiffOptions& options) {
  try {
    const FileComparison comparison = compare(options);
    const std::string text =
        options.writes_json ? format_comparison_json(comparison) : format_comparison(comparison);
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    if (std::ferror(stdout) != 0) throw FileError("standard output", "the differences cannot be written");
    return comparison.differences.empty() ? same : different;
  } catch (const DeckError& error) {
    print_errors(error.diagnostics());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
  }
  return unreadable;
}

}  // namespace contactsim
