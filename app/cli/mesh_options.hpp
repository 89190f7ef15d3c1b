// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace contactsim {

/// What `contactsim mesh` is asked for.
struct MeshOptions {
  bool is_asked = false;  ///< whether the command line says mesh
  std::string from, to;   ///< files
};

/// Adds the subcommand `mesh`.
CLI::App* add_mesh(CLI::App& app, MeshOptions& options);

}  // namespace contactsim
