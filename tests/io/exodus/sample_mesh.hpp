// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/mesh/mesh.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// A small mesh with something of everything: solids, shells, lines, particles, attributes, an empty block,
/// sets (one empty), nested assemblies, names and number maps.
MeshBuilder sample_mesh();

/// Two hexes on top of each other as blocks 10 (lower) and 20 (upper), 12 nodes, side set 1 (top), node set
/// 100.
MeshBuilder two_hexes();

/// Requires that two meshes agree in everything but the path.
void check_same(const Mesh& found, const Mesh& expected);

/// Writes the mesh, lets `damage` change the file, and reads it: the text of the refusal without the path, ""
/// when it was read.
std::string refusal(const Mesh& mesh, const std::function<void(ExodusEditor&)>& damage);

/// Writes the mesh, changes it and reads it; the warnings as they are printed, one per line, without the
/// path.
std::string warnings_of(const Mesh& mesh, const std::function<void(ExodusEditor&)>& change);

/// Writes the mesh, changes it and reads it.
Mesh reread(const Mesh& mesh, const std::function<void(ExodusEditor&)>& change,
            const ExodusLayout& layout = {});

}  // namespace contactsim::test
