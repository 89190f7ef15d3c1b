// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf_output.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/errors.hpp"

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
  check(nc_create(place_.unfinished().c_str(), NC_CLOBBER | (large ? NC_64BIT_DATA : NC_64BIT_OFFSET), &id_),
        "created");
  is_open_ = true;
  int ignored = 0;
  check(nc_set_fill(id_, NC_NOFILL, &ignored), "written");
}

NetcdfOutput::~NetcdfOutput() {
  if (!is_open_) return;
  if (is_published_) {
    close_at_last_sync();
    return;
  }
  nc_abort(id_);
  place_.discard();
}

void NetcdfOutput::check(int status, const std::string& what) const {
  if (!is_open_ && status == NC_EBADID) throw FileError(path_, "was closed when it could not be written");
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

void NetcdfOutput::write_record(int variable, std::size_t record, std::span<const double> values) {
  const std::array<std::size_t, 2> start{record, 0}, count{1, values.size()};
  n_written_ = std::max(n_written_, record + 1);
  check(nc_put_vara_double(id_, variable, start.data(), count.data(), values.data()), "written");
}

void NetcdfOutput::publish() {
  check(nc_sync(id_), "written");
  header_.open(place_.unfinished(), std::ios::binary | std::ios::in | std::ios::out);
  if (!header_) throw FileError(path_, "cannot be opened again while it is written");
  const std::string problem = place_.commit();
  if (!problem.empty()) throw FileError(path_, "cannot be written (" + problem + ")");
  is_published_ = true;
}

void NetcdfOutput::sync() {
  check(nc_sync(id_), "written");
  n_synced_ = n_written_;
}

void NetcdfOutput::close_at_last_sync() {
  if (!is_open_) return;
  nc_close(id_);
  is_open_ = false;
  id_ = -1;
  if (n_written_ > n_synced_) restore_record_count();
  header_.close();
}

// netCDF counts a record as soon as its first value is given, and closing writes the count even when the
// values could not be: the file would claim what it does not hold. The count follows the four letters of the
// magic number, big-endian, in 4 bytes (CDF-2) or 8 (CDF-5). Source: netCDF User's Guide, appendix B.
void NetcdfOutput::restore_record_count() {
  const int n_bytes = is_large_ ? 8 : 4;
  std::string count;
  for (int byte = n_bytes - 1; byte >= 0; --byte) {
    count.push_back(static_cast<char>(n_synced_ >> (8 * byte) & 0xff));
  }
  header_.seekp(4);
  header_.write(count.data(), n_bytes);
  header_.flush();
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
