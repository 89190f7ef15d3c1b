// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/netcdf/netcdf_file.hpp"
#include "io/netcdf/netcdf_layout.hpp"

namespace contactsim {

/// All that a file defines. Throws FileError for variables of types that are neither texts nor numbers;
/// attributes of such types are left out.
NetcdfLayout read_layout(const NetcdfFile& file);

}  // namespace contactsim
