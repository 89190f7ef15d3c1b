// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <netcdf.h>

#include <stdexcept>

namespace contactsim::test {

/// A test's own netCDF call must not fail.
inline void check(int status) {
  if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

}  // namespace contactsim::test
