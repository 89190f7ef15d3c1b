// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// Reads the assemblies of an Exodus file; `parts` has its blocks and sets. Nested assemblies may stand
/// before or after their members. Assemblies of kinds that contactsim does not use are kept without members.
/// Throws FileError for members that do not exist and for assemblies that contain themselves.
std::vector<Assembly> read_assemblies(const ExodusFile& file, const MeshParts& parts, Diagnostics& warnings);

}  // namespace contactsim
