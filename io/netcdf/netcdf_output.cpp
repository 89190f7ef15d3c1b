// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/netcdf_output.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <array>
#include <cassert>
#include <functional>
#include <map>
#include <numeric>
#include <type_traits>
#include <utility>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

nc_type to_nc_type(NetcdfType type) {
  constexpr std::array<nc_type, 5> types{NC_CHAR, NC_INT, NC_INT64, NC_FLOAT, NC_DOUBLE};
  return types[static_cast<std::size_t>(type)];
}

}  // namespace

static_assert(sizeof(long long) == sizeof(std::int64_t));
static_assert(NetcdfOutput::global == NC_GLOBAL && NetcdfOutput::unlimited == NC_UNLIMITED);

NetcdfOutput::NetcdfOutput(std::string path, bool large)
    : path_(std::move(path)), place_(path_), is_large_(large) {
  if (!place_.is_regular()) throw FileError(path_, "cannot be created (it is not a regular file)");
  create(place_.unfinished(), NC_CLOBBER);
}

NetcdfOutput::NetcdfOutput(bool large) : path_("results to be measured"), place_(path_), is_large_(large) {
  create(place_.unfinished(), NC_DISKLESS);
}

void NetcdfOutput::create(const std::string& path, int mode) {
  check(nc_create(path.c_str(), mode | (is_large_ ? NC_64BIT_DATA : NC_64BIT_OFFSET), &id_), "created");
  is_open_ = true;
  int ignored = 0;
  check(nc_set_fill(id_, NC_NOFILL, &ignored), "written");
}

NetcdfOutput::~NetcdfOutput() {
  if (!is_open_) return;
  nc_abort(id_);
  place_.discard();
}

void NetcdfOutput::check(int status, const std::string& what) const {
  if (status != NC_NOERR) throw FileError(path_, fmt::format("cannot be {} ({})", what, nc_strerror(status)));
}

int NetcdfOutput::define_dimension(const std::string& name, std::size_t length) {
  int dimension = 0;
  check(nc_def_dim(id_, name.c_str(), length, &dimension), "written: dimension " + name);
  return dimension;
}

int NetcdfOutput::define_variable(const std::string& name, NetcdfType type,
                                  const std::vector<int>& dimensions) {
  int variable = 0;
  check(nc_def_var(id_, name.c_str(), to_nc_type(type), static_cast<int>(dimensions.size()),
                   dimensions.data(), &variable),
        "written: variable " + name);
  return variable;
}

void NetcdfOutput::set_text(int variable, const std::string& attribute, const std::string& text) {
  check(nc_put_att_text(id_, variable, attribute.c_str(), text.size(), text.c_str()),
        "written: " + attribute);
}

void NetcdfOutput::set_number(int variable, const std::string& attribute, NetcdfType type, double value) {
  check(nc_put_att_double(id_, variable, attribute.c_str(), to_nc_type(type), 1, &value),
        "written: " + attribute);
}

void NetcdfOutput::set_integer(int variable, const std::string& attribute, NetcdfType type,
                               std::int64_t value) {
  const long long number = value;
  check(nc_put_att_longlong(id_, variable, attribute.c_str(), to_nc_type(type), 1, &number),
        "written: " + attribute);
}

void NetcdfOutput::set_attribute(int variable, const NetcdfAttribute& attribute) {
  const char* name = attribute.name.c_str();
  const nc_type type = to_nc_type(attribute.type);
  const auto put = [&](const auto& values) {
    if constexpr (std::is_same_v<decltype(values.data()), const char*>)
      return nc_put_att_text(id_, variable, name, values.size(), values.data());
    else if constexpr (std::is_same_v<decltype(values.data()), const double*>)
      return nc_put_att_double(id_, variable, name, type, values.size(), values.data());
    else
      return nc_put_att_longlong(id_, variable, name, type, values.size(),
                                 reinterpret_cast<const long long*>(values.data()));
  };
  check(std::visit(put, attribute.values), "written: " + attribute.name);
}

void NetcdfOutput::define(const NetcdfLayout& layout) {
  std::map<std::string, int> dimensions;
  for (const NetcdfDimension& dimension : layout.dimensions) {
    assert(dimension.is_unlimited || dimension.length > 0);
    dimensions[dimension.name] =
        define_dimension(dimension.name, dimension.is_unlimited ? unlimited : dimension.length);
  }
  for (const NetcdfDefinition& variable : layout.variables) {
    std::vector<int> of_variable;
    for (const std::string& dimension : variable.dimensions) of_variable.push_back(dimensions.at(dimension));
    const int id = define_variable(variable.name, variable.type, of_variable);
    for (const NetcdfAttribute& attribute : variable.attributes) set_attribute(id, attribute);
  }
  for (const NetcdfAttribute& attribute : layout.attributes) set_attribute(global, attribute);
}

void NetcdfOutput::end_definitions() { check(nc_enddef(id_), "written"); }

void NetcdfOutput::write(int variable, std::span<const std::int32_t> values) {
  check(nc_put_var_int(id_, variable, values.data()), "written");
}

void NetcdfOutput::write(int variable, std::span<const std::int64_t> values) {
  check(nc_put_var_longlong(id_, variable, reinterpret_cast<const long long*>(values.data())), "written");
}

void NetcdfOutput::write(int variable, std::span<const double> values) {
  check(nc_put_var_double(id_, variable, values.data()), "written");
}

void NetcdfOutput::write(int variable, std::size_t width, const std::vector<std::string>& texts) {
  std::string rows;
  for (std::string text : texts) {
    text.resize(width, '\0');
    rows += text;
  }
  check(nc_put_var_text(id_, variable, rows.data()), "written");
}

void NetcdfOutput::write(int variable, std::optional<std::size_t> record, const NetcdfValues& values) {
  int rank = 0;
  check(nc_inq_varndims(id_, variable, &rank), "written");
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(id_, variable, dimensions.data()), "written");
  std::vector<std::size_t> start(dimensions.size(), 0), count(dimensions.size());
  for (std::size_t i = 0; i < dimensions.size(); ++i)
    check(nc_inq_dimlen(id_, dimensions[i], &count[i]), "written");
  if (record) {
    start.at(0) = *record;
    count.at(0) = 1;
  }
  const auto put = [&](const auto& all) {
    assert(all.size() == std::accumulate(count.begin(), count.end(), std::size_t{1}, std::multiplies<>()));
    if constexpr (std::is_same_v<decltype(all.data()), const char*>)
      return nc_put_vara_text(id_, variable, start.data(), count.data(), all.data());
    else if constexpr (std::is_same_v<decltype(all.data()), const double*>)
      return nc_put_vara_double(id_, variable, start.data(), count.data(), all.data());
    else
      return nc_put_vara_longlong(id_, variable, start.data(), count.data(),
                                  reinterpret_cast<const long long*>(all.data()));
  };
  check(std::visit(put, values), "written");
}

void NetcdfOutput::commit() {
  check(nc_sync(id_), "written");
  check(nc_close(id_), "written");
  is_open_ = false;
  id_ = -1;
  const std::string problem = place_.commit();
  if (!problem.empty()) throw FileError(path_, "cannot be written (" + problem + ")");
}

}  // namespace contactsim
