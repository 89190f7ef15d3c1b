// SPDX-License-Identifier: BSD-3-Clause
#include "app/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/counted.hpp"
#include "app/exit_guard.hpp"
#include "app/file_clashes.hpp"
#include "app/run_mesh.hpp"
#include "app/surface_report.hpp"
#include "contact/contact_model.hpp"
#include "contact/surface_drawing.hpp"
#include "core/mesh/element_checks.hpp"
#include "io/exodus_reader.hpp"
#include "io/surface_writer.hpp"
#include "io/write_text.hpp"
#include "parser/deck.hpp"

namespace contactsim {

namespace {

/// Stops with all problems when one of them is an error.
void stop_on_errors(const Diagnostics& diagnostics) {
  if (diagnostics.has_errors()) throw DeckError(diagnostics);
}

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
  return fmt::format("  {}, {}, {}, {}, {} with contact\n", counted(definition.materials.size(), "material"),
                     counted(definition.sections.size(), "section"),
                     counted(definition.functions.size(), "function"),
                     counted(definition.procedures.size(), "procedure"),
                     counted(regions_with_contact(definition).size(), "region"));
}

std::string describe(const Mesh& mesh) {
  std::string text =
      fmt::format("  {}, {}, {}, {}, {}, {}\n", counted(mesh.n_nodes(), "node"),
                  counted(mesh.n_elements(), "element"), counted(mesh.blocks().size(), "block"),
                  counted(mesh.side_sets().size(), "side set"), counted(mesh.node_sets().size(), "node set"),
                  counted(mesh.assemblies().size(), "assembly", "assemblies"));
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const ElementBlock& block = mesh.blocks()[i];
    const std::string type = block.shape == Shape::unknown ? fmt::format("'{}'", block.type_name)
                                                           : std::string(topology(block.shape).name);
    text += fmt::format("  block {:<28} id {:>8} {:>10} elements {}\n", mesh.name({EntityKind::block, i}),
                        block.id, block.n_elements, type);
  }
  return text;
}

/// The region to work on: with contact before without, of an explicit procedure before an implicit one, then
/// the first.
Region choose_region(const SimulationDefinition& definition, Diagnostics& warnings) {
  const Region* chosen = nullptr;
  int best = -1;
  for (const Procedure& procedure : definition.procedures) {
    for (const Region& region : procedure.regions) {
      const int merit = (region.contact ? 2 : 0) + (procedure.implicit_by ? 0 : 1);
      if (merit <= best) continue;
      best = merit;
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
  return chosen != nullptr ? *chosen : Region{};
}

/// Blocks whose elements must be sound because contact skins or lofts them.
std::vector<std::uint32_t> blocks_in_contact(const ContactModel& model, const Mesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.blocks().size(), 0);
  for (const ContactSurface& surface : model.surfaces.surfaces) {
    for (const ElementSide face : surface.faces) is_used[mesh.block_of(face.element())] = 1;
    for (const ElementIndex element : surface.lofted_elements) is_used[mesh.block_of(element)] = 1;
  }
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i]) blocks.push_back(i);
  }
  return blocks;
}

/// Writes the files that are asked for. One that cannot be written does not keep the others from it.
ExitCode write_surface_files(const Options& options, const ContactModel& model,
                             std::span<const SurfaceSummary> summaries, const Mesh& mesh, Log& log) {
  ExitCode code = ExitCode::done;
  const auto write = [&](const std::optional<std::string>& path, const auto& write_file) {
    if (!path) return;
    const auto work = [&] { return write_file(*path), ExitCode::done; };
    const ExitCode own = guard_exit(work, [&](const std::string& line) { log.write_error(line); });
    if (own != ExitCode::done) code = own;
  };
  write(options.surfaces_json,
        [&](const std::string& path) { write_text(path, format_surfaces_json(model, summaries)); });
  write(options.surfaces_csv, [&](const std::string& path) {
    write_text(path, format_surfaces_csv(model, list_facets(model, mesh)));
  });
  write(options.surfaces_exodus, [&](const std::string& path) {
    write_facet_mesh(path, draw_surfaces(model, mesh), "contact surfaces");
  });
  return code;
}

/// Adds what the tables warn of to the summary at the end.
void add_surface_warnings(const ContactSurfaces& surfaces, Diagnostics& warnings) {
  for (const SurfaceWarning& warning : surfaces.warnings) {
    warnings.add_warning(warning.id, warning.location, warning.text);
  }
}

ExitCode check_surfaces(const Options& options, const SimulationDefinition& definition, const Region& region,
                        const Mesh& mesh, Log& log, Diagnostics& warnings) {
  if (!region.contact) {
    log.write("\nThe deck has no contact definition.\n");
    return write_surface_files(options, {}, {}, mesh, log);
  }
  const ContactModel model = make_contact_model(definition, region, mesh, {}, warnings);
  stop_on_errors(warnings);
  check_elements(mesh, blocks_in_contact(model, mesh), warnings);
  const auto summaries = summarize(model, mesh);
  log.write(format_surface_tables(model, summaries));
  add_surface_warnings(model.surfaces, warnings);
  return write_surface_files(options, model, summaries, mesh, log);
}

/// A deck with errors goes no further, but wrong names of surfaces are found all the same, so that one run
/// shows all that is wrong. Without a mesh that can be read there is nothing to compare them with.
void add_name_errors(const Options& options, const SimulationDefinition& definition, Diagnostics& errors) {
  Diagnostics of_the_mesh;
  const Region region = choose_region(definition, of_the_mesh);
  if (!region.contact) return;
  try {
    const Mesh mesh = read_mesh(run_mesh_path(options, definition, region), of_the_mesh);
    find_name_errors(definition, region, mesh, errors);
  } catch (const FileError&) {
    return;
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
  if (warnings.has_errors()) {
    if (options.stage != Stage::parse) add_name_errors(options, definition, warnings);
    throw DeckError(warnings);
  }
  log.write(fmt::format("Deck {}\n{}", options.deck, describe(definition)));
  if (options.stage == Stage::parse) return ExitCode::done;

  const Region region = choose_region(definition, warnings);
  check_mesh_is_kept(options, run_mesh_path(options, definition, region));
  const Mesh mesh = read_run_mesh(options, definition, region, warnings);
  log.write(fmt::format("Mesh {}\n{}", mesh.path(), describe(mesh)));
  const ExitCode code = check_surfaces(options, definition, region, mesh, log, warnings);
  if (options.stage == Stage::check || code != ExitCode::done) return code;
  log.write_error("error: the run ends here: this version resolves contact surfaces (--check) only");
  return ExitCode::solve;
}

}  // namespace contactsim
