// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/base/errors.hpp"
#include "io/decompose/split_file.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "io/pieces/exodus_file.hpp"
#include "support/temporary_directory.hpp"

namespace contactsim::test {

/// The pieces m.g.P.r of a mesh in a directory of their own, without the whole.
class SplitMesh {
 public:
  SplitMesh(const Mesh& mesh, std::size_t n_pieces, const ExodusLayout& layout = {}) : n_pieces_(n_pieces) {
    write_exodus(base(), mesh, layout);
    split_file(base(), n_pieces);
    std::filesystem::remove(base());
  }

  std::string base() const { return directory_.file("m.g"); }
  std::string piece(std::size_t number) const { return name_pieces(base(), n_pieces_).path(number); }

  Mesh read() const {
    Diagnostics warnings;
    return read_mesh(base(), warnings);
  }
  /// How they refuse to be read, without the directory; "" when they are read.
  std::string refusal() const {
    try {
      read();
      return "";
    } catch (const FileError& error) {
      std::string text = error.what();
      const std::string folder = directory_.file("");
      for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
        text.erase(at, folder.size());
      return text;
    }
  }

 private:
  TemporaryDirectory directory_;
  std::size_t n_pieces_;
};

/// Eight hexahedra in a row along x, as blocks 1 (five) and 2 (three) with the side set 1 on top and the node
/// set 1 at z = 0, both in the order of elements and nodes.
inline MeshBuilder row_of_hexes() {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {5, 1, 1}, .size = {5, 1, 1}})
      .add_hexes({.id = 2, .cells = {3, 1, 1}, .origin = {5, 0, 0}, .size = {3, 1, 1}});
  builder.add_side_set(1, "top", [](const CandidateSide& side) { return side.normal.z() > 0.5; });
  builder.add_node_set(1, "bottom", [](const Eigen::Vector3d& position) { return position.z() == 0.0; });
  return builder;
}

/// All numbers of a variable of any file.
inline std::vector<std::int64_t> integers_of(const std::string& path, const std::string& variable) {
  const NetcdfFile file(path);
  const NetcdfVariable found = file.find_variable(variable).value();
  std::vector<std::int64_t> values(found.size());
  file.read_int64(found, values);
  return values;
}

}  // namespace contactsim::test
