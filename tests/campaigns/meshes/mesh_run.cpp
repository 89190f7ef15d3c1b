// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/mesh_run.hpp"

#include <numeric>

#include "app/run/simulation.hpp"
#include "app/run/stop_on_errors.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_summary.hpp"
#include "contact/overlap/initial_gaps.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/element_checks.hpp"
#include "parser/deck.hpp"

namespace contactsim::test {

namespace {

constexpr const char* head = R"(begin sierra
begin material m
density = 8000
begin parameters for model elastic
youngs modulus = 200e9
poissons ratio = 0.3
end
end
begin shell section sheet
thickness = 0.1
end
begin beam section rod
section = rod
width = 0.1
height = 0.1
t axis = 0 0 1
end
begin truss section wire
area = 0.01
end
begin point mass section dust
mass = 1
end
begin finite element model f
)";

constexpr const char* tail = R"(end
begin presto procedure p
begin time control
begin time stepping block t
start time = 0
begin parameters for presto region r
end
end
termination time = 1e-9
end
begin presto region r
use finite element model f
begin initial velocity
include all blocks
component = z
magnitude = 10
end
begin contact definition
skin all blocks = on
begin interaction defaults
general contact = on
self contact = on
friction model = slippery
end
begin frictionless model slippery
end
end
end
end
end
)";

std::string section_of(const ElementBlock& block) {
  switch (topology(block.shape).family) {
    case Family::shell:
      return "section = sheet\n";
    case Family::line:
      return topology(block.shape).name.starts_with("BEAM") ? "section = rod\n" : "section = wire\n";
    case Family::particle:
      return "section = dust\n";
    default:
      return "";
  }
}

std::string deck_of(const Mesh& mesh) {
  std::string deck = head;
  for (const ElementBlock& block : mesh.blocks()) {
    deck += "begin parameters for block block_" + std::to_string(block.id) +
            "\nmaterial = m\nmodel = elastic\n" + section_of(block) + "end\n";
  }
  return deck + tail;
}

std::vector<std::uint32_t> all_blocks(const Mesh& mesh) {
  std::vector<std::uint32_t> blocks(mesh.blocks().size());
  std::iota(blocks.begin(), blocks.end(), 0u);
  return blocks;
}

}  // namespace

void run_mesh(const Mesh& mesh) {
  Diagnostics diagnostics;
  const SimulationDefinition definition =
      parse_deck_text("deck.i", deck_of(mesh), {}, diagnostics, read_no_file);
  stop_on_errors(diagnostics);
  const Procedure& procedure = definition.procedures.front();
  const Region& region = procedure.regions.front();
  const ContactModel contact = make_contact_model(definition, region, mesh, diagnostics);
  stop_on_errors(diagnostics);
  check_elements(mesh, all_blocks(mesh));
  summarize(contact, mesh);
  find_initial_gaps(contact, mesh, region.contact->dash);
  const auto overlaps = find_start_overlaps(contact, mesh, *region.contact);
  Simulation simulation({definition, procedure, region, mesh, &contact, overlaps}, {}, diagnostics);
  simulation.begin();
  if (!simulation.is_over()) simulation.step();
  simulation.finish();
}

}  // namespace contactsim::test
