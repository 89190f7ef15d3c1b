// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/import/draft_mesh.hpp"

namespace contactsim {

/// Reads a mesh of Gmsh in text, of format 2.2 or 4.1. Groups are its physical groups; without any, its
/// entities of the highest dimension. Throws FileError with the line. Source: Gmsh 4.8 reference manual,
/// section 9 (file formats) and 9.2 (node ordering).
DraftMesh read_msh(const std::string& path);

}  // namespace contactsim
