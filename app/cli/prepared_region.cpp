// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/prepared_region.hpp"

#include <fmt/format.h>

#include <utility>

#include "app/cli/run_mesh.hpp"
#include "app/cli/surface_stage.hpp"
#include "app/reports/deck_report.hpp"
#include "app/reports/overlap_report.hpp"
#include "app/reports/surface_report.hpp"
#include "app/run/start_overlap.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "contact/output/surface_summary.hpp"
#include "core/base/memory_error.hpp"
#include "core/base/pluralize.hpp"
#include "core/definition/simulation.hpp"
#include "core/elements/cohesive_section.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

namespace {

std::shared_ptr<Mesh> read_and_log_mesh(const DeckWay& way, const Region& region) {
  const std::string path =
      find_exodus_path(run_mesh_path(way.options, way.definition, region), way.options.n_ranks);
  if (way.options.summary)
    way.summary.mesh = {path, digest_of_files(list_mesh_files(path)), std::nullopt, std::nullopt};
  auto mesh = std::make_shared<Mesh>(with_cohesive_blocks(
      way.definition, region, read_run_mesh(way.options, way.definition, region, way.warnings)));
  const auto pieces = find_pieces(mesh->path());
  way.log.write(
      fmt::format("Mesh {}\n{}{}", mesh->path(),
                  pieces ? fmt::format("  joined from {}\n", pluralize(pieces->count, "piece")) : "",
                  format_mesh(*mesh)));
  way.draft.has_mesh = true;
  if (way.summary.mesh)
    way.summary.mesh = {path, way.summary.mesh->digest, mesh->n_nodes(), mesh->n_elements()};
  return mesh;
}

/// That of the region's finite element model; one of its own where overlap removal may move nodes.
std::shared_ptr<Mesh> find_mesh(const DeckWay& way, const Region& region, MeshesByModel& meshes) {
  std::shared_ptr<Mesh>& known = meshes[find_finite_element_model(way.definition, region)];
  if (!known) known = tell_lack_of_memory("reading the mesh", [&] { return read_and_log_mesh(way, region); });
  const bool may_move = region.contact && region.contact->overlap_removal.is_on();
  return may_move ? std::make_shared<Mesh>(*known) : known;
}

/// Removes overlaps where the deck wants it.
void part_overlaps(const DeckWay& way, PreparedRegion& prepared) {
  const RunInput input = prepared.input(way.definition);
  auto removed = remove_initial_overlap(input);
  if (!removed) return;
  way.log.write(format_overlap(*removed, *input.contact, input.mesh));
  auto moved = move_nodes(input, std::move(*removed), way.warnings);
  if (!moved) return;
  *prepared.mesh = std::move(*moved);
  refit_smoothings(*prepared.mesh, *prepared.contact);
}

void find_overlaps(const DeckWay& way, PreparedRegion& prepared) {
  // Where a state is taken over they are found in it.
  if (!prepared.contact || !prepared.procedure.transfers.empty()) return;
  prepared.overlaps = find_start_overlaps(*prepared.contact, *prepared.mesh, *prepared.region.contact);
  way.log.write(format_start_overlaps(prepared.overlaps, *prepared.contact, *prepared.mesh));
}

void resolve(const DeckWay& way, bool writes_tables, PreparedRegion& prepared) {
  // Without contact the tables that are asked for are empty.
  if (!prepared.region.contact && way.options.stage == Stage::run &&
      !(writes_tables && asks_for_tables(way.options)))
    return;
  Options options = way.options;
  if (!writes_tables) {
    for (auto* path : {&options.surfaces_json, &options.surfaces_csv, &options.surfaces_exodus})
      path->reset();
  }
  const Mesh& mesh = *prepared.mesh;
  auto [model, code] = resolve_contact(options, way.definition, prepared.region, mesh, way.log, way.warnings);
  prepared.contact = std::move(model);
  prepared.code = code;
  if (!prepared.contact) return;
  note_pairs(*prepared.contact, way.summary);
  if (way.options.report && writes_tables)
    way.draft.surfaces = format_surfaces_json(*prepared.contact, summarize(*prepared.contact, mesh));
}

}  // namespace

RunInput PreparedRegion::input(const SimulationDefinition& definition) const {
  return {definition, procedure, region, *mesh, contact ? &*contact : nullptr, overlaps};
}

PreparedRegion prepare_region(const DeckWay& way, const ChosenRegion& chosen, MeshesByModel& meshes,
                              bool writes_tables) {
  PreparedRegion prepared{chosen.procedure, chosen.region, nullptr, {}, {}};
  prepared.mesh = find_mesh(way, prepared.region, meshes);
  way.signals.end_if_stopped();
  tell_lack_of_memory("finding the contact surfaces", [&] { resolve(way, writes_tables, prepared); });
  if (prepared.code != ExitCode::done) return prepared;
  way.signals.end_if_stopped();
  tell_lack_of_memory("finding overlaps at the start", [&] {
    part_overlaps(way, prepared);
    find_overlaps(way, prepared);
  });
  return prepared;
}

}  // namespace contactsim
