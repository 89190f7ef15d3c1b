// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Reads a three-dimensional Exodus II mesh of any netCDF format; results in the file are not looked at.
/// Everything that the mesh refers to exists afterwards: nodes, elements, sides, members of assemblies.
/// Blocks of element types that are unknown or missing are kept (Shape::unknown) and are an error only to who
/// uses them. `warnings` gains what the user should know, without deck locations. Throws FileError
/// "path: block 3 (name): element 17 ...", and MemoryError.
/// Source: Schoof & Yarberry, EXODUS II: A Finite Element Data Model, SAND92-2137 (1994).
Mesh read_mesh(const std::string& path, Diagnostics& warnings);

}  // namespace contactsim
