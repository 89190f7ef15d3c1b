// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/surface_stage.hpp"

#include "app/cli/exit_guard.hpp"
#include "app/reports/pair_report.hpp"
#include "app/reports/surface_report.hpp"
#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_drawing.hpp"
#include "contact/overlap/initial_gaps.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/element_checks.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/surface_writer.hpp"
#include "io/files/write_text.hpp"

namespace contactsim {

namespace {

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
///   contact  null without a contact definition
ExitCode write_surface_files(const Options& options, const ContactDefinition* contact,
                             const ContactModel& model, const SurfaceSummaries& summaries, const Mesh& mesh,
                             Log& log) {
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
    const std::vector<SurfaceOptions> none;
    write_facet_mesh(path, draw_surfaces(model, mesh, contact != nullptr ? contact->surface_options : none),
                     "contact surfaces");
  });
  return code;
}

/// Adds what the tables warn of to the summary at the end.
void add_surface_warnings(const ContactSurfaces& surfaces, Diagnostics& warnings) {
  for (const SurfaceWarning& warning : surfaces.warnings) {
    warnings.add_warning(warning.id, warning.location, warning.text);
  }
}

}  // namespace

ResolvedContact resolve_contact(const Options& options, const SimulationDefinition& definition,
                                const Region& region, const Mesh& mesh, Log& log, Diagnostics& warnings) {
  if (!region.contact) {
    log.write("\nThe deck has no contact definition.\n");
    return {std::nullopt, write_surface_files(options, nullptr, {}, {}, mesh, log)};
  }
  ContactModel model = make_contact_model(definition, region, mesh, warnings);
  stop_on_errors(warnings);
  check_elements(mesh, blocks_in_contact(model, mesh));
  const auto summaries = summarize(model, mesh);
  const auto starts = find_initial_gaps(model, mesh, region.contact->dash);
  log.write(
      format_surface_tables(model, summaries) + format_passed_over(model, mesh) +
      format_pairs(model, summaries, starts, find_automatic_lengths(model, mesh, region.contact->dash)));
  add_surface_warnings(model.surfaces, warnings);
  const ExitCode code = write_surface_files(options, &*region.contact, model, summaries, mesh, log);
  return {std::move(model), code};
}

void add_surface_name_errors(const SimulationDefinition& definition, const Region& region,
                             const std::string& mesh_path, Diagnostics& errors) {
  if (!region.contact) return;
  Diagnostics discarded;
  try {
    const Mesh mesh = read_mesh(mesh_path, discarded);
    find_name_errors(definition, region, mesh, errors);
  } catch (const FileError&) {
    return;
  }
}

}  // namespace contactsim
