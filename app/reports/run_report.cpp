// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_report.hpp"

#include <fmt/format.h>

#include "app/reports/number.hpp"
#include "app/reports/text_table.hpp"
#include "core/base/pluralize.hpp"
#include "core/elements/element_table.hpp"
#include "io/pieces/piece_files.hpp"

namespace contactsim {

namespace {

/// Sum over the elements, the copies that fill up the last batch left out.
double mass_of(const ModelBlock& block) {
  double mass = 0.0;
  for (std::size_t i = 0; i < block.n_elements; ++i)
    mass += block.mass[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes));
  return mass;
}

std::string format_subcycles(const Subcycles& subcycles) {
  if (subcycles.empty()) return "";
  return fmt::format(
      "  subcycling: {} elements in {} parts of each step, {} once: {:.3g} times fewer are advanced\n",
      subcycles.n_elements, subcycles.n_parts, subcycles.n_others, subcycles.saving());
}

}  // namespace

std::string format_model(const Model& model, const StepReport& at_start) {
  TextTable table(2, 1,
                  {name_column("block", 24),
                   {"elements", 10},
                   name_column("type", 9),
                   name_column("formulation", 22),
                   name_column("material", 20),
                   {"mass", 12}});
  double mass = 0.0;
  for (const ModelBlock& block : model.blocks) {
    mass += mass_of(block);
    table.add(model.mesh->name({EntityKind::block, block.mesh_block}), block.n_elements,
              topology(block.element->shape).name, block.element->formulation, block.material,
              number(mass_of(block)));
  }
  std::string text = "\nModel\n" + table.format();
  text += fmt::format("  mass {:.6g}, {} nodes held or driven\n", mass,
                      model.kinematic_constraints.nodes().size());
  if (!(at_start.stable_step > 0.0)) return text;  // of load steps
  text += fmt::format("  stable time step {:.6g}", at_start.stable_step);
  if (at_start.critical_element) {
    const ElementIndex element = *at_start.critical_element;
    text += fmt::format(", set by element {} of {}", model.mesh->element_id(element),
                        model.mesh->name({EntityKind::block, model.mesh->block_of(element)}));
  }
  return text + "\n" + format_subcycles(model.subcycles);
}

std::string format_ranks(const RankTraffic& traffic, bool is_static) {
  if (is_static) {
    return fmt::format(
        "  {} ranks: the busiest has {:.1f} % more elements and sends {} bytes to {} a trial, all get {}\n",
        traffic.n_ranks, 100.0 * traffic.imbalance, traffic.bytes_sent, traffic.n_messages,
        traffic.bytes_gathered);
  }
  return fmt::format(
      "  {} ranks: {:.1f} % of the nodes shared, the busiest has {:.1f} % more elements and sends {} bytes "
      "to {} "
      "a step\n",
      traffic.n_ranks, 100.0 * traffic.shared_nodes, 100.0 * traffic.imbalance, traffic.bytes_sent,
      traffic.n_messages);
}

std::string format_paths(std::span<const std::string> paths) {
  std::vector<std::string> named;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    named.push_back(paths[i]);
    const auto pieces = parse_piece_path(paths[i]);
    if (!pieces || pieces->count == 1 || paths[i] != pieces->path(0)) continue;
    named.back() += " to " + pieces->path(pieces->count - 1);
    i += pieces->count - 1;
  }
  return paths.empty() ? "" : fmt::format("  writes {}\n", fmt::join(named, ", "));
}

std::string step_heading() {
  return fmt::format("\n{:>9} {:>13} {:>12} {:>13} {:>13} {:>13} {:>13} {:>9}\n", "step", "time", "time step",
                     "kinetic", "internal", "external", "contact", "error %");
}

std::string format_step(const State& state) {
  const Energies& e = state.energies;
  const double error = e.largest > 0.0 ? 100.0 * e.error / e.largest : 0.0;
  return fmt::format("{:>9} {:>13.6e} {:>12.4e} {:>13.5e} {:>13.5e} {:>13.5e} {:>13.5e} {:>9.4f}\n",
                     state.step, state.time, state.next_dt, e.kinetic, e.internal, e.external, e.contact,
                     error);
}

std::string format_restart_source(const RunRestart& restart) {
  if (!restart.resumes()) return "";
  if (!restart.source()) {
    return fmt::format("\nRestart: there is no state in {} yet, the run begins at its start\n",
                       restart.input());
  }
  const StoredState& state = *restart.source();
  return fmt::format("\nRestart from {}: step {}, time {:.6g}{}\n", state.path, state.head.step,
                     state.head.time, restart.shifts() ? ", moved to the start time" : "");
}

std::string format_stored_states(const RunRestart& restart) {
  if (!restart.last_step()) return "";
  return fmt::format("\nRestart: {} stored, the last one of step {} in {}\n",
                     pluralize(static_cast<std::size_t>(restart.n_written()), "state"), *restart.last_step(),
                     restart.last_path());
}

std::string format_energy_balance(const Energies& energies, double stored_at_start,
                                  double given_out_by_overlaps, double ramped) {
  std::string text = "\nEnergy balance\n";
  const auto add = [&](const char* name, double energy) {
    text += fmt::format("  {:<30} {:>13.5e}\n", name, energy);
  };
  const double impact = energies.impact + given_out_by_overlaps + ramped;
  const double overlap_energy = stored_at_start + given_out_by_overlaps;
  const double lost = energies.friction + energies.contact_damping + energies.stabilization + impact;
  add("start, between half steps", energies.start);
  add("put in by the start, overlaps", overlap_energy);
  add("work of loads and motion", energies.external);
  add("kinetic", energies.kinetic);
  add("internal", energies.internal);
  add("held by contact", overlap_energy + energies.contact - lost);
  add("lost to friction", energies.friction);
  add("lost to contact damping", energies.contact_damping);
  if (energies.stabilization != 0.0) add("lost to stabilization", energies.stabilization);
  add("lost where sides met", impact);
  add("error of the balance", energies.error);
  return text;
}

std::string format_wall_times(std::span<const PartTime> parts, double whole, std::int64_t n_steps,
                              std::size_t n_elements) {
  std::string text = "\nWall time\n";
  const auto add = [&](const std::string& name, double seconds) {
    text += fmt::format("  {:<24} {:>10.3f} s {:>5.1f} %\n", name, seconds, 100.0 * seconds / whole);
  };
  for (const PartTime& part : parts) add(part.name, part.seconds);
  add("whole run", whole);
  const double steps = static_cast<double>(n_steps);
  text += fmt::format("  {:.6g} steps per second, {:.6g} million element-steps per second\n", steps / whole,
                      steps * static_cast<double>(n_elements) / whole * 1e-6);
  return text;
}

}  // namespace contactsim
