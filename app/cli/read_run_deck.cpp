// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/read_run_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "core/base/digest.hpp"
#include "core/base/errors.hpp"
#include "parser/deck.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

std::vector<std::pair<std::string, std::string>> split_definitions(
    const std::vector<std::string>& definitions) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& definition : definitions) {
    const std::size_t equals = definition.find('=');
    if (equals == std::string::npos || equals == 0) {
      Diagnostics mistake;
      mistake.add_error({}, fmt::format("-D {}: expected name=value", definition));
      throw DeckError(mistake);
    }
    pairs.emplace_back(definition.substr(0, equals), definition.substr(equals + 1));
  }
  return pairs;
}

std::filesystem::path include_path(const std::optional<std::string>& includes_folder,
                                   const std::string& name) {
  return includes_folder ? std::filesystem::path(*includes_folder) / name : std::filesystem::path(name);
}

RunDeck read_run_deck(const DeckRequest& request, Diagnostics& diagnostics) {
  ParseOptions options;
  options.is_lenient = request.is_lenient;
  options.overrides = split_definitions(request.definitions);
  const TextFile deck = read_text_file(request.path);
  // That says what is wrong with the file.
  if (deck.failure != TextFile::Failure::none) return {parse_deck(request.path, options, diagnostics)};

  Digest digest;
  std::vector<SourceFile> sources;
  const auto add = [&](const std::string& name, const std::string& text) {
    const std::uint64_t of_text = digest_of(text);
    digest.add_values(std::span(&of_text, 1));
    if (std::ranges::find(sources, name, &SourceFile::name) == sources.end()) sources.push_back({name, text});
  };
  add(request.path, deck.text);
  const FileReader read_file = [&](const std::string& path) {
    const TextFile file = read_text_file(include_path(request.includes_folder, path));
    add(path, file.text);
    return file;
  };
  RunDeck run{parse_deck_text(request.path, deck.text, options, diagnostics, read_file)};
  run.digest = digest.value();
  run.sources = std::move(sources);
  return run;
}

namespace {

/// Tells of a procedure or a region that is not the chosen one.
void tell_of_other(const char* what, const DeckName& other, const DeckName& chosen, bool may_pass_over,
                   Diagnostics& diagnostics) {
  const int length = std::max(1, static_cast<int>(other.text.size()));
  if (may_pass_over) {
    diagnostics.add_warning("deck-region", other.location,
                            fmt::format("the {} '{}' is passed over", what, other.text),
                            fmt::format("that of '{}' is taken", chosen.text), length);
  } else {
    diagnostics.add_error(
        other.location, fmt::format("a second {} is not supported here", what),
        fmt::format("'{}' would be run without it: make it a deck of its own, or pass it over "
                    "with --lenient",
                    chosen.text),
        length);
  }
}

}  // namespace

int merit_of(const Procedure& procedure, const Region& region) {
  return (region.contact ? 2 : 0) + (procedure.implicit_by ? 0 : 1);
}

ChosenRegion choose_region(const SimulationDefinition& definition, bool may_pass_over,
                           Diagnostics& diagnostics) {
  const Procedure* of = nullptr;
  const Region* chosen = nullptr;
  int best = -1;
  for (const Procedure& procedure : definition.procedures) {
    for (const Region& region : procedure.regions) {
      const int merit = merit_of(procedure, region);
      if (merit <= best) continue;
      best = merit;
      of = &procedure;
      chosen = &region;
    }
  }
  if (chosen == nullptr) return {};
  for (const Procedure& procedure : definition.procedures) {
    if (&procedure != of) {
      tell_of_other("procedure", procedure.name, of->name, may_pass_over, diagnostics);
      continue;
    }
    for (const Region& region : procedure.regions) {
      if (&region != chosen) tell_of_other("region", region.name, chosen->name, may_pass_over, diagnostics);
    }
  }
  return {*of, *chosen};
}

std::vector<ChosenRegion> choose_regions(const SimulationDefinition& definition, bool may_pass_over,
                                         Diagnostics& diagnostics) {
  std::vector<ChosenRegion> all;
  for (const Procedure& procedure : definition.procedures) {
    const auto merit = [&](const Region& region) { return merit_of(procedure, region); };
    const auto best = std::ranges::max_element(procedure.regions, {}, merit);
    if (best == procedure.regions.end()) continue;
    for (const Region& region : procedure.regions) {
      if (&region != &*best) tell_of_other("region", region.name, best->name, may_pass_over, diagnostics);
    }
    all.push_back({procedure, *best});
  }
  if (all.empty()) all.emplace_back();
  for (const Procedure& procedure : definition.procedures) {
    if (procedure.regions.empty() && definition.procedures.size() > 1)
      diagnostics.add_error(procedure.name.location,
                            fmt::format("the procedure '{}' has no region", procedure.name.text));
  }
  return all;
}

}  // namespace contactsim
