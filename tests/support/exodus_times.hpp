// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "io/netcdf/netcdf_file.hpp"

namespace contactsim::test {

/// The times of all steps of an Exodus file.
inline std::vector<double> read_times(const NetcdfFile& file) {
  const NetcdfVariable variable = file.find_variable("time_whole").value();
  std::vector<double> times(variable.size());
  file.read_double(variable, times);
  return times;
}

}  // namespace contactsim::test
