// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/mesh_options.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

/// `contactsim mesh`: reads, writes, and prints what became of each group. Throws FileError.
ExitCode convert_mesh(const MeshOptions& options);

}  // namespace contactsim
