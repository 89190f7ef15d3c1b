// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/run_mesh.hpp"
#include "app/cli/surface_stage.hpp"
#include "app/run/file_clashes.hpp"
#include "app/run/simulation.hpp"
#include "app/run/start_overlap.hpp"
#include "core/base/pluralize.hpp"
#include "parser/deck.hpp"

namespace contactsim {

namespace {

ParseOptions parse_options(const Options& options) {
  ParseOptions parse;
  parse.is_lenient = options.is_lenient;
  for (const std::string& definition : options.definitions) {
    const std::size_t equals = definition.find('=');
    if (equals == std::string::npos || equals == 0) {
      Diagnostics mistake;
      mistake.add_error({}, fmt::format("-D {}: expected name=value", definition));
      throw DeckError(mistake);
    }
    parse.overrides.emplace_back(definition.substr(0, equals), definition.substr(equals + 1));
  }
  return parse;
}

std::string describe(const SimulationDefinition& definition) {
  return fmt::format(
      "  {}, {}, {}, {}, {} with contact\n", pluralize(definition.materials.size(), "material"),
      pluralize(definition.sections.size(), "section"), pluralize(definition.functions.size(), "function"),
      pluralize(definition.procedures.size(), "procedure"),
      pluralize(regions_with_contact(definition).size(), "region"));
}

std::string describe(const Mesh& mesh) {
  std::string text = fmt::format(
      "  {}, {}, {}, {}, {}, {}\n", pluralize(mesh.n_nodes(), "node"),
      pluralize(mesh.n_elements(), "element"), pluralize(mesh.blocks().size(), "block"),
      pluralize(mesh.side_sets().size(), "side set"), pluralize(mesh.node_sets().size(), "node set"),
      pluralize(mesh.assemblies().size(), "assembly", "assemblies"));
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const ElementBlock& block = mesh.blocks()[i];
    const std::string type = block.shape == Shape::unknown ? fmt::format("'{}'", block.type_name)
                                                           : std::string(topology(block.shape).name);
    text += fmt::format("  block {:<28} id {:>8} {:>10} elements {}\n", mesh.name({EntityKind::block, i}),
                        block.id, block.n_elements, type);
  }
  return text;
}

/// A region and the procedure that it is part of.
struct ChosenRegion {
  Procedure procedure;
  Region region;
};

/// The region to work on: with contact before without, of an explicit procedure before an implicit one, then
/// the first.
ChosenRegion choose_region(const SimulationDefinition& definition, Diagnostics& warnings) {
  const Procedure* of = nullptr;
  const Region* chosen = nullptr;
  int best = -1;
  for (const Procedure& procedure : definition.procedures) {
    for (const Region& region : procedure.regions) {
      const int merit = (region.contact ? 2 : 0) + (procedure.implicit_by ? 0 : 1);
      if (merit <= best) continue;
      best = merit;
      of = &procedure;
      chosen = &region;
    }
  }
  for (const Region* other : regions_with_contact(definition)) {
    if (other == chosen) continue;
    warnings.add_warning("deck-region", other->name.location,
                         fmt::format("the contact of the region '{}' is passed over", other->name.text),
                         fmt::format("that of '{}' is resolved", chosen->name.text),
                         static_cast<int>(other->name.text.size()));
  }
  return chosen != nullptr ? ChosenRegion{*of, *chosen} : ChosenRegion{};
}

/// Whether a run may resume from where an earlier one was.
bool asks_to_resume(const SimulationDefinition& definition) {
  if (definition.restart.is_automatic || definition.restart.time) return true;
  for (const Procedure& procedure : definition.procedures) {
    for (const Region& region : procedure.regions) {
      if (std::ranges::any_of(region.restart_data, [](const RestartData& restart) {
            return restart.is_automatic || restart.restart_time;
          }))
        return true;
    }
  }
  return false;
}

/// A deck with errors goes no further, but wrong names of surfaces are found all the same.
void add_name_errors(const Options& options, const SimulationDefinition& definition, Diagnostics& errors) {
  Diagnostics discarded, found;
  const Region region = choose_region(definition, discarded).region;
  add_surface_name_errors(definition, region, run_mesh_path(options, definition, region), found);
  // What the deck alone shows to be wrong has been reported.
  const auto is_reported = [known = errors.all()](const Diagnostic& error) {
    return std::ranges::any_of(known, [&](const Diagnostic& other) {
      return other.severity == Severity::error && error.severity == Severity::error &&
             to_string(other.location) == to_string(error.location);
    });
  };
  for (const Diagnostic& error : found.all()) {
    if (!is_reported(error)) errors.add(error);
  }
}

/// The mesh that the deck names must outlive the run as well.
void check_mesh_is_kept(const Options& options, const std::string& mesh_path) {
  const RunFile mesh{mesh_path, "the mesh"};
  const std::string clash = find_file_clash({&mesh, 1}, files_written(options));
  if (!clash.empty()) throw FileError(mesh_path, clash);
}

}  // namespace

ExitCode simulate(const Options& options, Log& log, Diagnostics& warnings) {
  const SimulationDefinition definition = parse_deck(options.deck, parse_options(options), warnings);
  log.begin(asks_to_resume(definition));
  if (warnings.has_errors()) {
    if (options.stage != Stage::parse) add_name_errors(options, definition, warnings);
    throw DeckError(warnings);
  }
  log.write(fmt::format("Deck {}\n{}", options.deck, describe(definition)));
  if (options.stage == Stage::parse) return ExitCode::done;

  const ChosenRegion chosen = choose_region(definition, warnings);
  const Region& region = chosen.region;
  check_mesh_is_kept(options, run_mesh_path(options, definition, region));
  const Mesh mesh = read_run_mesh(options, definition, region, warnings);
  log.write(fmt::format("Mesh {}\n{}", mesh.path(), describe(mesh)));
  ResolvedContact contact;
  if (region.contact || options.stage == Stage::check) {
    contact = resolve_contact(options, definition, region, mesh, log, warnings);
    if (contact.code != ExitCode::done) return contact.code;
  }
  const ContactModel* model = contact.model ? &*contact.model : nullptr;
  const RunInput input{options, definition, chosen.procedure, region, mesh, model};
  const std::optional<Mesh> moved = remove_initial_overlap(input, log, warnings);
  const RunInput started{options, definition, chosen.procedure, region, moved ? *moved : mesh, model};
  const std::vector<StartOverlap> overlaps = find_overlaps(started, log);
  if (options.stage == Stage::check) {
    warn_of_overlaps(started, overlaps, {}, warnings);
    return ExitCode::done;
  }
  return run_transient({options, definition, chosen.procedure, region, started.mesh, model, overlaps}, log,
                       warnings);
}

}  // namespace contactsim
