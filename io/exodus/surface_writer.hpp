// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/mesh/facet_mesh.hpp"

namespace contactsim {

/// Writes surfaces as an Exodus mesh that ParaView opens and colours by block. Each becomes an element block
/// of its own name with the id position + 1: shells of four nodes (a triangle among them repeats its last
/// node), shells of three nodes when all facets are triangles, bars for edges or spheres for points. Empty
/// surfaces become empty blocks. The file replaces an older one only when it is whole, and the same surfaces
/// give the same bytes.
///   title  at most 80 characters are kept
/// Throws FileError when the file cannot be written.
void write_facet_mesh(const std::string& path, const FacetMesh& mesh, const std::string& title);

}  // namespace contactsim
