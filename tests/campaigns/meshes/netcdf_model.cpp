// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/netcdf_model.hpp"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace contactsim::test {

namespace {

void check(int status) {
  if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

using Name = std::array<char, NC_MAX_NAME + 1>;

std::vector<NetcdfAttribute> read_attributes(int file, int variable, int n) {
  std::vector<NetcdfAttribute> attributes;
  for (int i = 0; i < n; ++i) {
    Name name{};
    std::size_t length = 0;
    NetcdfAttribute attribute;
    check(nc_inq_attname(file, variable, i, name.data()));
    check(nc_inq_att(file, variable, name.data(), &attribute.values.type, &length));
    attribute.name = name.data();
    NetcdfValues& values = attribute.values;
    if (values.is_text()) {
      values.texts.resize(length);
      check(nc_get_att_text(file, variable, name.data(), values.texts.data()));
    } else if (values.is_real()) {
      values.reals.resize(length);
      check(nc_get_att_double(file, variable, name.data(), values.reals.data()));
    } else {
      values.integers.resize(length);
      check(nc_get_att_longlong(file, variable, name.data(), values.integers.data()));
    }
    attributes.push_back(attribute);
  }
  return attributes;
}

NetcdfArray read_array(int file, int variable, const NetcdfModel& model) {
  Name name{};
  int rank = 0, n_attributes = 0, storage = 0;
  NetcdfArray array;
  check(nc_inq_var(file, variable, name.data(), &array.values.type, &rank, nullptr, &n_attributes));
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(file, variable, dimensions.data()));
  array.name = name.data();
  array.dimensions.assign(dimensions.begin(), dimensions.end());
  array.attributes = read_attributes(file, variable, n_attributes);
  check(nc_inq_var_chunking(file, variable, &storage, nullptr));
  array.is_chunked = storage == NC_CHUNKED;
  std::size_t n = 1;
  for (const std::size_t dimension : array.dimensions) n *= model.dimensions[dimension].length;
  NetcdfValues& values = array.values;
  if (n == 0) return array;
  if (values.is_text()) {
    values.texts.resize(n);
    check(nc_get_var_text(file, variable, values.texts.data()));
  } else if (values.is_real()) {
    values.reals.resize(n);
    check(nc_get_var_double(file, variable, values.reals.data()));
  } else {
    values.integers.resize(n);
    check(nc_get_var_longlong(file, variable, values.integers.data()));
  }
  return array;
}

void put_attributes(int file, int variable, const std::vector<NetcdfAttribute>& attributes) {
  for (const auto& [name, values] : attributes) {
    if (values.is_text()) {
      nc_put_att_text(file, variable, name.c_str(), values.texts.size(), values.texts.data());
    } else if (values.is_real()) {
      nc_put_att_double(file, variable, name.c_str(), values.type, values.reals.size(), values.reals.data());
    } else {
      nc_put_att_longlong(file, variable, name.c_str(), values.type, values.integers.size(),
                          values.integers.data());
    }
  }
}

constexpr std::size_t largest_array = 1 << 17;

/// How many values an array has by its dimensions, or some number beyond the largest array.
std::size_t count_values(const NetcdfArray& array, const NetcdfModel& model) {
  std::size_t n = 1;
  for (const std::size_t dimension : array.dimensions) {
    n *= std::min(largest_array + 1, model.dimensions[dimension].length);
    if (n > largest_array) return n;
  }
  return n;
}

/// Puts what there is: netCDF reads as many values as the dimensions say.
void put_values(int file, int variable, const NetcdfArray& array, const NetcdfModel& model) {
  const std::size_t n = count_values(array, model);
  if (n > largest_array) return;
  std::vector<std::size_t> start(array.dimensions.size(), 0), count;
  for (const std::size_t dimension : array.dimensions) count.push_back(model.dimensions[dimension].length);
  NetcdfValues values = array.values;
  values.texts.resize(n);
  values.reals.resize(n);
  values.integers.resize(n, 1);
  if (values.is_text()) {
    nc_put_vara_text(file, variable, start.data(), count.data(), values.texts.data());
  } else if (values.is_real()) {
    nc_put_vara_double(file, variable, start.data(), count.data(), values.reals.data());
  } else {
    nc_put_vara_longlong(file, variable, start.data(), count.data(), values.integers.data());
  }
}

}  // namespace

bool NetcdfValues::is_text() const { return type == NC_CHAR; }
bool NetcdfValues::is_real() const { return type == NC_FLOAT || type == NC_DOUBLE; }
std::size_t NetcdfValues::size() const {
  return is_text() ? texts.size() : is_real() ? reals.size() : integers.size();
}

NetcdfModel read_netcdf_model(const std::string& path) {
  int file = 0, n_dimensions = 0, n_variables = 0, n_attributes = 0, unlimited = -1;
  check(nc_open(path.c_str(), NC_NOWRITE, &file));
  check(nc_inq(file, &n_dimensions, &n_variables, &n_attributes, &unlimited));
  NetcdfModel model;
  for (int i = 0; i < n_dimensions; ++i) {
    Name name{};
    NetcdfDimension dimension;
    check(nc_inq_dim(file, i, name.data(), &dimension.length));
    dimension.name = name.data();
    dimension.is_unlimited = i == unlimited;
    model.dimensions.push_back(dimension);
  }
  model.attributes = read_attributes(file, NC_GLOBAL, n_attributes);
  for (int i = 0; i < n_variables; ++i) model.arrays.push_back(read_array(file, i, model));
  check(nc_close(file));
  return model;
}

void write_netcdf_model(const std::string& path, const NetcdfModel& model, int mode) {
  int file = 0;
  if (nc_create(path.c_str(), NC_CLOBBER | mode, &file) != NC_NOERR) return;
  std::vector<int> dimension_ids(model.dimensions.size(), -1), array_ids(model.arrays.size(), -1);
  nc_set_fill(file, NC_NOFILL, nullptr);
  for (std::size_t i = 0; i < dimension_ids.size(); ++i) {
    const NetcdfDimension& dimension = model.dimensions[i];
    nc_def_dim(file, dimension.name.c_str(), dimension.is_unlimited ? NC_UNLIMITED : dimension.length,
               &dimension_ids[i]);
  }
  put_attributes(file, NC_GLOBAL, model.attributes);
  for (std::size_t i = 0; i < array_ids.size(); ++i) {
    const NetcdfArray& array = model.arrays[i];
    // A classic file is as long as all its variables, be there values or not.
    if ((mode & NC_NETCDF4) == 0 && count_values(array, model) > largest_array) continue;
    std::vector<int> dimensions;
    for (const std::size_t dimension : array.dimensions) dimensions.push_back(dimension_ids[dimension]);
    const int status = nc_def_var(file, array.name.c_str(), array.values.type,
                                  static_cast<int>(dimensions.size()), dimensions.data(), &array_ids[i]);
    if (status != NC_NOERR) {
      array_ids[i] = -1;
      continue;
    }
    put_attributes(file, array_ids[i], array.attributes);
    if (array.is_chunked && (mode & NC_NETCDF4) != 0) nc_def_var_deflate(file, array_ids[i], 1, 1, 1);
  }
  nc_enddef(file);
  for (std::size_t i = 0; i < array_ids.size(); ++i) {
    if (array_ids[i] >= 0) put_values(file, array_ids[i], model.arrays[i], model);
  }
  nc_close(file);
}

}  // namespace contactsim::test
