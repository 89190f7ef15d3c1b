// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <regex>
#include <utility>

#include "core/base/errors.hpp"
#include "core/base/memory_error.hpp"
#include "io/exodus/exodus_assemblies.hpp"
#include "io/exodus/exodus_blocks.hpp"
#include "io/exodus/exodus_entities.hpp"
#include "io/exodus/exodus_nodes.hpp"
#include "io/exodus/exodus_sets.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

namespace {

void check_is_exodus(const ExodusFile& file) {
  if (const int n_groups = file.n_groups(); n_groups > 0) {
    file.fail(fmt::format(
        "holds {} netCDF groups (several meshes in one file); write the wanted one to a file of its own",
        n_groups));
  }
  const auto version = file.find_global_number("version");
  if (!version) file.fail("is netCDF but not Exodus (no global attribute 'version')");
  if (!(*version >= 2.0)) file.fail(fmt::format("is Exodus version {}; 2 or later is needed", *version));
  const std::size_t n_dimensions = file.dimension("num_dim");
  if (n_dimensions == 0) file.fail("is netCDF but not an Exodus mesh (no dimension 'num_dim')");
  if (n_dimensions != 3) {
    file.fail(fmt::format("is a {}-dimensional mesh; contactsim needs three dimensions", n_dimensions));
  }
}

// One rank's part of a mesh looks like a whole mesh, with cut faces as if they were exterior.
void check_is_whole(const ExodusFile& file, Diagnostics& warnings) {
  if (file.n_pieces()) return;
  const double n_processors = file.find_global_number("processor_info").value_or(1.0);
  if (n_processors > 1.0 || file.dimension("num_processors") > 1) {
    file.fail(
        "is one piece of a decomposed mesh, but not named as one is, like mesh.g.4.0; the pieces cannot "
        "be found");
  }
  static const std::regex piece_name(R"(\.[0-9]+\.[0-9]+$)");
  if (std::regex_search(file.path(), piece_name)) {
    warn(warnings, file, "mesh-piece",
         "is named like one piece of a decomposed mesh; it is read as a whole mesh");
  }
}

void warn_of_unread(const ExodusFile& file, Diagnostics& warnings) {
  constexpr std::array<std::pair<const char*, const char*>, 5> unread{{{"num_elem_sets", "element sets"},
                                                                       {"num_ed_blk", "edge blocks"},
                                                                       {"num_fa_blk", "face blocks"},
                                                                       {"num_edge_sets", "edge sets"},
                                                                       {"num_face_sets", "face sets"}}};
  for (const auto& [dimension, what] : unread) {
    if (const std::size_t n = file.dimension(dimension); n > 0) {
      warn(warnings, file, "mesh-entities-ignored", fmt::format("its {} {} are not read", n, what));
    }
  }
}

Mesh read_open_file(const ExodusFile& file, Diagnostics& warnings) {
  check_is_exodus(file);
  check_is_whole(file, warnings);
  warn_of_unread(file, warnings);
  MeshParts parts;
  parts.path = file.path();
  parts.title = file.find_global_text("title").value_or("");
  parts.coordinates = read_coordinates(file);
  const auto n_nodes = static_cast<std::uint32_t>(parts.coordinates.cols());
  parts.blocks = read_blocks(file, n_nodes, warnings);
  std::size_t n_elements = 0;
  for (const ElementBlock& block : parts.blocks) n_elements += block.n_elements;
  parts.node_ids = read_ids(file, "node_num_map", n_nodes, "node", warnings);
  parts.element_ids = read_ids(file, "elem_num_map", n_elements, "element", warnings);
  parts.side_sets = read_side_sets(file, parts.blocks, warnings);
  parts.node_sets = read_node_sets(file, n_nodes, warnings);
  parts.assemblies = read_assemblies(file, parts, warnings);
  return Mesh(std::move(parts));
}

}  // namespace

Mesh read_mesh(const std::string& path, Diagnostics& warnings) {
  return tell_lack_of_memory("reading the mesh " + path,
                             [&] { return read_open_file(ExodusFile(path), warnings); });
}

}  // namespace contactsim
