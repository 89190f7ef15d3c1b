// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/convert_mesh.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "core/base/names.hpp"
#include "core/base/pluralize.hpp"
#include "core/base/version.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/import/inp_reader.hpp"
#include "io/import/make_mesh.hpp"
#include "io/import/msh_reader.hpp"

namespace contactsim {

namespace {

DraftMesh read_draft(const std::string& path) {
  const std::string ending = fold(std::filesystem::path(path).extension().string());
  if (ending == ".msh") return read_msh(path);
  if (ending == ".inp") return read_inp(path);
  throw FileError(path, "expected a mesh of Gmsh (.msh) or an input file of Abaqus or CalculiX (.inp)");
}

}  // namespace

ExitCode convert_mesh(const MeshOptions& options) {
  const MadeMesh made = make_mesh(read_draft(options.from));
  const std::string title = std::filesystem::path(options.from).filename().string();
  const ResultsWriter writer(options.to, made.mesh, {title, {{"contactsim", version, "", ""}}, {}}, {});
  std::string text = fmt::format("{}: {}, {}\n", options.to, pluralize(made.mesh.n_nodes(), "node"),
                                 pluralize(made.mesh.n_elements(), "element"));
  for (const std::string& note : made.notes) text += "  " + note + "\n";
  std::fputs(text.c_str(), stdout);
  return ExitCode::done;
}

}  // namespace contactsim
