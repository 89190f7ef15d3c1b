// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/mesh_options.hpp"

#include <CLI/CLI.hpp>

namespace contactsim {

namespace {

constexpr const char* mesh_footer =
    "Groups keep their names: of volumes they are blocks; of surfaces on volumes side sets, else blocks of\n"
    "shells; of lines and points on what is meshed node sets, else blocks of beams and spheres.\n"
    "Gmsh: text, format 4.1 or 2.2, physical groups. Abaqus and CalculiX: *NODE, *ELEMENT, *ELSET, *NSET,\n"
    "*SURFACE, sections; one part.\n"
    "Examples:   gmsh -3 plate.geo -format msh41 && contactsim mesh plate.msh plate.g\n"
    "            contactsim mesh model.inp model.g";

}  // namespace

CLI::App* add_mesh(CLI::App& app, MeshOptions& options) {
  auto* mesh = app.add_subcommand("mesh", "Make an Exodus mesh of one of Gmsh, Abaqus or CalculiX");
  mesh->footer(mesh_footer);
  mesh->add_option("from", options.from, "Mesh of Gmsh (.msh) or input file of Abaqus or CalculiX (.inp)")
      ->type_name("FILE")
      ->required();
  mesh->add_option("to", options.to, "Exodus mesh to write")->type_name("MESH")->required();
  return mesh;
}

}  // namespace contactsim
