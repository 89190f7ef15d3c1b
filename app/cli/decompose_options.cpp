// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/decompose_options.hpp"

#include <CLI/CLI.hpp>

namespace contactsim {

namespace {

constexpr const char* split_footer =
    "Pieces are named as Sandia's decomp and nem_spread name them, mesh.g.16.00 to mesh.g.16.15, and hold "
    "what\n"
    "those write: ParaView, epu and Sierra read them. Whole elements are divided by recursive coordinate\n"
    "bisection; pieces share the nodes between them. A run needs no pieces: it shares its work itself.\n"
    "Examples:   contactsim split mesh.g 4\n"
    "            contactsim split plate.e.4.0 16";

constexpr const char* join_footer =
    "Does what Sandia's epu does for pieces of any program that names them so: mesh.g.16.00 to "
    "mesh.g.16.15.\n"
    "Where contactsim reads a mesh or results it takes pieces as they are, and none need be joined before.\n"
    "Examples:   contactsim join out.e.4.0\n"
    "            contactsim join out.e all.e";

}  // namespace

CLI::App* add_split(CLI::App& app, SplitOptions& options) {
  auto* split = app.add_subcommand("split", "Decompose a mesh or results into pieces, as decomp does");
  split->footer(split_footer);
  split->add_option("file", options.file, "Exodus file, or pieces to divide anew")
      ->type_name("MESH")
      ->required();
  split->add_option("pieces", options.n_pieces, "Number of pieces; they are written beside the file")
      ->type_name("P")
      ->required()
      ->check(CLI::Range(1, 1000000));
  return split;
}

CLI::App* add_join(CLI::App& app, JoinOptions& options) {
  auto* join = app.add_subcommand("join", "Join the pieces of a decomposed mesh or results, as epu does");
  join->footer(join_footer);
  join->add_option("pieces", options.pieces, "One of the pieces, or their name without numbers")
      ->type_name("MESH")
      ->required();
  join->add_option("to", options.to, "Exodus file to write; without it the name without numbers")
      ->type_name("FILE");
  return join;
}

}  // namespace contactsim
