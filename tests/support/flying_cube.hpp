// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/run/simulation.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/definition/simulation.hpp"
#include "parser/deck.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// Lines of a deck beside those of a flying cube.
struct CubeLines {
  std::string contact =
      "begin interaction defaults\ngeneral contact = on\nend\n";  ///< of the contact definition, before the
                                                                  ///< skin
  std::string region = "";
  std::string parameters = "";  ///< of the block "upper"
  std::string time = "";        ///< of the parameters of the time stepping block
};

/// A unit cube "upper" of density 1 and one element that flies with speed 1 into the unit cube "lower" of 8
/// elements, over a gap of 0.01; a simulation without files. The deck is "a.i".
struct FlyingCube {
  explicit FlyingCube(const CubeLines& lines = {})
      : mesh(MeshBuilder()
                 .add_hexes({1, "lower", {2, 2, 2}})
                 .add_hexes({2, "upper", {1, 1, 1}, {0, 0, 1.01}, {1, 1, 1}, false})
                 .build()),
        definition(parse_deck_text("a.i", deck_of(lines), {}, diagnostics)),
        contact(make_contact_model(definition, region(), mesh, diagnostics)),
        simulation({definition, definition.procedures.front(), region(), mesh, &contact}, {}, diagnostics) {}

  const Region& region() const { return definition.procedures.front().regions.front(); }
  /// Begins, and takes some steps.
  void run(int n_steps) {
    simulation.begin();
    for (int i = 0; i < n_steps; ++i) simulation.step();
  }
  void run_to_end() {
    simulation.begin();
    while (!simulation.is_over()) simulation.step();
    simulation.finish();
  }

  Diagnostics diagnostics;
  Mesh mesh;
  SimulationDefinition definition;
  ContactModel contact;
  Simulation simulation;

 private:
  static std::string deck_of(const CubeLines& lines) {
    const std::string elastic = "material = m\nmodel = elastic\n";
    return "begin sierra\nbegin material m\ndensity = 1\nbegin parameters for model elastic\n"
           "youngs modulus = 100\npoissons ratio = 0.3\nend\nend\nbegin finite element model f\n"
           "begin parameters for block lower\n" +
           elastic + "end\nbegin parameters for block upper\n" + elastic + lines.parameters +
           "end\nend\nbegin presto procedure p\nbegin time control\nbegin time stepping block t\n"
           "start time = 0\nbegin parameters for presto region r\n" +
           lines.time +
           "end\nend\ntermination time = 0.5\nend\n"
           "begin presto region r\nuse finite element model f\n"
           "begin initial velocity\nblock = upper\ncomponent = z\nmagnitude = -1\nend\n"
           "begin contact definition\n" +
           lines.contact + "skin all blocks = on\nend\n" + lines.region + "end\nend\nend\n";
  }
};

}  // namespace contactsim::test
