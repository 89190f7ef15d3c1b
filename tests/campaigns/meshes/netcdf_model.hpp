// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace contactsim::test {

/// Values of a variable or an attribute, in the list that fits their type.
struct NetcdfValues {
  int type = 0;  ///< of netCDF: NC_CHAR, NC_INT, ...
  std::string texts;
  std::vector<long long> integers;
  std::vector<double> reals;

  bool is_text() const;
  bool is_real() const;
  std::size_t size() const;
};

struct NetcdfAttribute {
  std::string name;
  NetcdfValues values;
};

struct NetcdfDimension {
  std::string name;
  std::size_t length = 0;
  bool is_unlimited = false;
};

struct NetcdfArray {
  std::string name;
  std::vector<std::size_t> dimensions;  ///< positions in NetcdfModel::dimensions
  std::vector<NetcdfAttribute> attributes;
  NetcdfValues values;  ///< perhaps not as many as the dimensions say
  bool is_chunked = false;
};

/// A whole netCDF file in memory, whatever its format, to be changed and written.
struct NetcdfModel {
  std::vector<NetcdfDimension> dimensions;
  std::vector<NetcdfAttribute> attributes;
  std::vector<NetcdfArray> arrays;
};

/// Throws std::runtime_error when netCDF refuses.
NetcdfModel read_netcdf_model(const std::string& path);

/// Writes as much of a model as netCDF takes: names, types and lengths may be wrong.
///   mode  of nc_create: NC_64BIT_OFFSET, NC_NETCDF4, ...
void write_netcdf_model(const std::string& path, const NetcdfModel& model, int mode);

}  // namespace contactsim::test
