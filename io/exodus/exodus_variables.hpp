// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/mesh/mesh.hpp"
#include "core/mesh/stored_variables.hpp"

namespace contactsim {

/// The nodal and element variables that an Exodus file stores beside its mesh, of any netCDF format. The file
/// stays open as long as the result can be asked to read. Throws FileError when they do not match the mesh
/// or the times do not rise.
///   path  of the file that the mesh was read from
/// Source: Schoof & Yarberry, EXODUS II: A Finite Element Data Model, SAND92-2137 (1994), results variables.
StoredVariables read_stored_variables(const std::string& path, const Mesh& mesh);

}  // namespace contactsim
