// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "support/mesh_builder.hpp"

/// Decks of two cubes in code or on files: the elastic blocks low and high of a finite element model f.
namespace contactsim::test {

/// The cube low of 8 elements, and above it the cube high of one, so far apart.
inline MeshBuilder two_cube_mesh(double gap) {
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "low", .cells = {2, 2, 2}});
  return b.add_hexes({.id = 2, .name = "high", .origin = {0, 0, 1.0 + gap}, .share_nodes = false});
}

/// A procedure of a name with a region of that name.
struct DeckProcedure {
  std::string name = "p";
  double start = 0.0, end = 0.1;
  std::string region = {};  ///< lines of the region
  std::string more = {};    ///< lines of the procedure before its times
};

/// Explicit, or of four load steps: "adagio".
inline std::string text_of(const DeckProcedure& of, const std::string& kind = "presto") {
  return "begin " + kind + " procedure " + of.name + "\n" + of.more +
         "begin time control\nbegin time stepping block t\nstart time = " + std::to_string(of.start) + "\n" +
         (kind == "adagio"
              ? "begin parameters for adagio region " + of.name + "\nnumber of time steps = 4\nend\n"
              : "") +
         "end\ntermination time = " + std::to_string(of.end) + "\nend\nbegin " + kind + " region " + of.name +
         "\nuse finite element model f\n" + of.region + "end\nend\n";
}

/// A deck of procedures; density, modulus and with them the speed of waves are 1.
///   model  further lines of the finite element model
inline std::string two_cube_deck(const std::string& procedures, const std::string& model = "") {
  const std::string block = "material = m\nmodel = elastic\nend\n";
  return "begin sierra\nbegin material m\ndensity = 1\nbegin parameters for model elastic\n"
         "youngs modulus = 1\npoissons ratio = 0\nend\nend\nbegin finite element model f\n" +
         model + "begin parameters for block low\n" + block + "begin parameters for block high\n" + block +
         "end\n" + procedures + "end\n";
}

/// The contact definition of a region, with general contact of all skins.
inline std::string two_cube_contact(const std::string& more = "", const std::string& of_pairs = "") {
  return "begin contact definition c\nskin all blocks = on\n" + more +
         "begin interaction defaults\ngeneral contact = on\n" + of_pairs + "end\nend\n";
}

}  // namespace contactsim::test
