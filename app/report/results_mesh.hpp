// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/diagnostics.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The mesh of a results file without the block RigidBodyOutputPart, which a run adds for its rigid bodies
/// and no deck knows; its nodes stay. Throws FileError.
///   warnings  gains what is odd about the mesh
Mesh read_results_mesh(const std::string& path, Diagnostics& warnings);

}  // namespace contactsim
