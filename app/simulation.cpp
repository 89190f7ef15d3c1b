// SPDX-License-Identifier: BSD-3-Clause
#include "app/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

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
  const auto n_regions = regions_with_contact(definition).size();
  return fmt::format("  {} materials, {} sections, {} functions, {} procedures, {} regions with contact\n",
                     definition.materials.size(), definition.sections.size(), definition.functions.size(),
                     definition.procedures.size(), n_regions);
}

std::string describe(const Mesh& mesh) {
  std::string text =
      fmt::format("  {} nodes, {} elements, {} blocks, {} side sets, {} node sets, {} assemblies\n",
                  mesh.n_nodes(), mesh.n_elements(), mesh.blocks().size(), mesh.side_sets().size(),
                  mesh.node_sets().size(), mesh.assemblies().size());
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
Region choose_region(const SimulationDefinition& definition) {
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
  return chosen ? *chosen : Region{};
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

void write_surface_files(const Options& options, const ContactModel& model,
                         std::span<const SurfaceSummary> summaries, const Mesh& mesh) {
  if (options.surfaces_json) write_text(*options.surfaces_json, format_surfaces_json(model, summaries));
  if (options.surfaces_csv)
    write_text(*options.surfaces_csv, format_surfaces_csv(model, list_facets(model, mesh)));
  if (options.surfaces_exodus) {
    write_facet_mesh(*options.surfaces_exodus, draw_surfaces(model, mesh), "contact surfaces");
  }
}

/// Adds what the tables warn of to the summary at the end.
void add_surface_warnings(const ContactSurfaces& surfaces, Diagnostics& warnings) {
  for (const SurfaceWarning& warning : surfaces.warnings) {
    warnings.add_warning(warning.id, warning.location, warning.text);
  }
}

void check_surfaces(const Options& options, const SimulationDefinition& definition, const Region& region,
                    const Mesh& mesh, Log& log, Diagnostics& warnings) {
  const ContactModel model = make_contact_model(definition, region, mesh, {}, warnings);
  stop_on_errors(warnings);
  check_elements(mesh, blocks_in_contact(model, mesh));
  const auto summaries = summarize(model, mesh);
  log.write(format_surface_tables(model, summaries));
  write_surface_files(options, model, summaries, mesh);
  add_surface_warnings(model.surfaces, warnings);
}

/// A deck with errors goes no further, but wrong names of surfaces are found all the same, so that one run
/// shows all that is wrong. Without a mesh that can be read there is nothing to compare them with.
void add_name_errors(const Options& options, const SimulationDefinition& definition, Diagnostics& errors) {
  const Region region = choose_region(definition);
  if (!region.contact) return;
  try {
    Diagnostics mesh_warnings;
    const Mesh mesh = read_mesh(options.mesh.value_or(mesh_path(definition, region)), mesh_warnings);
    find_name_errors(definition, region, mesh, errors);
  } catch (const FileError&) {
    return;
  }
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

  const Region region = choose_region(definition);
  const Mesh mesh = read_mesh(options.mesh.value_or(mesh_path(definition, region)), warnings);
  log.write(fmt::format("Mesh {}\n{}", mesh.path(), describe(mesh)));
  if (region.contact) {
    check_surfaces(options, definition, region, mesh, log, warnings);
  } else {
    log.write("\nThe deck has no contact definition.\n");
  }
  if (options.stage == Stage::check) return ExitCode::done;
  log.write("\nThis version resolves contact surfaces; it does not integrate in time yet.\n");
  return ExitCode::solve;
}

}  // namespace contactsim
