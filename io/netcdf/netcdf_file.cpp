// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/netcdf_file.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <utility>

#include "core/base/errors.hpp"
#include "io/netcdf/classic_layout.hpp"
#include "io/netcdf/clean_text.hpp"
#include "io/netcdf/file_kind.hpp"
#include "io/netcdf/library_guard.hpp"

namespace contactsim {

namespace {

// Deflate packs at most 1032 bytes into one (Deutsch, RFC 1951); no other filter is usual in meshes.
constexpr std::uint64_t largest_compression = 1100;

/// A part of a variable as netCDF takes it.
struct Part {
  std::vector<std::size_t> start, count;

  std::size_t size() const {
    std::size_t n = 1;
    for (std::size_t length : count) n *= length;
    return n;
  }
};

Part make_part(const NetcdfVariable& variable, Rows rows) {
  Part part{std::vector<std::size_t>(variable.shape.size(), 0), variable.shape};
  if (variable.shape.empty()) return part;
  assert(rows.first + rows.count <= variable.shape[0]);
  part.start[0] = rows.first;
  part.count[0] = rows.count;
  return part;
}

std::string_view call_damage(FileKind kind) {
  if (kind == FileKind::classic) return "damaged netCDF header";
  if (kind == FileKind::hdf5) return "damaged or truncated HDF5 file";
  return "is not a netCDF or Exodus file";
}

}  // namespace

std::size_t NetcdfVariable::size() const {
  std::size_t n = 1;
  for (std::size_t length : shape) n *= length;
  return n;
}

NetcdfFile::NetcdfFile(std::string path) : path_(std::move(path)) {
  const FileKind kind = find_file_kind(path_);
  file_size_ = std::filesystem::file_size(path_);
  if (kind == FileKind::classic) check_classic_layout(path_);
  const LibraryGuard guard(path_);
  const int status = nc_open(path_.c_str(), NC_NOWRITE, &id_);
  if (status != NC_NOERR) fail(fmt::format("{} ({})", call_damage(kind), nc_strerror(status)));
}

NetcdfFile::~NetcdfFile() {
  const LibraryGuard guard(path_);
  nc_close(id_);
}

void NetcdfFile::fail(const std::string& what) const { throw FileError(path_, what); }

void NetcdfFile::check(int status, const std::string& what) const {
  if (status != NC_NOERR) fail(fmt::format("{} cannot be read ({})", what, nc_strerror(status)));
}

std::size_t NetcdfFile::dimension(const std::string& name) const {
  const LibraryGuard guard(path_);
  int id = 0;
  std::size_t length = 0;
  const int status = nc_inq_dimid(id_, name.c_str(), &id);
  if (status == NC_EBADDIM) return 0;
  check(status, "dimension " + name);
  check(nc_inq_dimlen(id_, id, &length), "dimension " + name);
  return length;
}

std::optional<NetcdfVariable> NetcdfFile::find_variable(const std::string& name) const {
  const LibraryGuard guard(path_);
  NetcdfVariable variable;
  variable.name = name;
  const int status = nc_inq_varid(id_, name.c_str(), &variable.id);
  if (status == NC_ENOTVAR) return std::nullopt;
  const std::string what = "variable " + name;
  check(status, what);
  nc_type type = NC_NAT;
  int rank = 0;
  check(nc_inq_var(id_, variable.id, nullptr, &type, &rank, nullptr, nullptr), what);
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(id_, variable.id, dimensions.data()), what);
  for (int dimension : dimensions) {
    check(nc_inq_dimlen(id_, dimension, &variable.shape.emplace_back()), what);
  }
  variable.is_text = type == NC_CHAR;
  variable.is_64_bit_integer = type == NC_INT64 || type == NC_UINT64;
  int storage = NC_CONTIGUOUS;
  std::vector<std::size_t> chunk(variable.shape.size(), 0);
  check(nc_inq_var_chunking(id_, variable.id, &storage, chunk.data()), what);
  variable.is_chunked = storage == NC_CHUNKED;
  check_fits(variable, variable.shape);
  // HDF5 makes room for a whole chunk, however little of it is asked for.
  if (variable.is_chunked && variable.size() > 0) check_fits(variable, chunk);
  return variable;
}

void NetcdfFile::check_fits(const NetcdfVariable& variable, std::span<const std::size_t> lengths) const {
  nc_type type = NC_NAT;
  std::size_t bytes_per_value = 0;
  check(nc_inq_vartype(id_, variable.id, &type), variable.name);
  check(nc_inq_type(id_, type, nullptr, &bytes_per_value), variable.name);
  std::uint64_t room = variable.is_chunked ? file_size_ * largest_compression : file_size_;
  room /= std::max<std::size_t>(bytes_per_value, 1);
  for (const std::size_t length : lengths) {
    if (length == 0) return;
    room /= length;
  }
  if (room == 0) fail(fmt::format("variable {} claims more values than the file can hold", variable.name));
}

std::vector<std::string> NetcdfFile::variable_names(std::string_view prefix) const {
  int n_variables = 0;
  check(nc_inq_nvars(id_, &n_variables), "the list of variables");
  std::vector<std::string> names;
  for (int v = 0; v < n_variables; ++v) {
    char name[NC_MAX_NAME + 1] = {};
    check(nc_inq_varname(id_, v, name), "a variable's name");
    if (std::string_view(name).starts_with(prefix)) names.emplace_back(name);
  }
  return names;
}

int NetcdfFile::n_groups() const {
  int n = 0;
  check(nc_inq_grps(id_, &n, nullptr), "the list of groups");
  return n;
}

std::optional<double> NetcdfFile::find_global_number(const std::string& name) const {
  const LibraryGuard guard(path_);
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(id_, NC_GLOBAL, name.c_str(), &type, &length) != NC_NOERR) return std::nullopt;
  if (type == NC_CHAR || type == NC_STRING || length == 0) return std::nullopt;
  std::vector<double> values(length);
  check(nc_get_att_double(id_, NC_GLOBAL, name.c_str(), values.data()), "attribute " + name);
  return values.front();
}

std::optional<std::string> NetcdfFile::find_global_text(const std::string& name) const {
  return find_text_attribute(NC_GLOBAL, name);
}

std::optional<std::int64_t> NetcdfFile::find_integer(const NetcdfVariable& variable,
                                                     const std::string& attribute) const {
  const LibraryGuard guard(path_);
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(id_, variable.id, attribute.c_str(), &type, &length) != NC_NOERR) return std::nullopt;
  if (type == NC_CHAR || type == NC_STRING || length != 1) return std::nullopt;
  long long value = 0;
  check(nc_get_att_longlong(id_, variable.id, attribute.c_str(), &value), variable.name + ":" + attribute);
  return value;
}

std::optional<std::string> NetcdfFile::find_text(const NetcdfVariable& variable,
                                                 const std::string& attribute) const {
  return find_text_attribute(variable.id, attribute);
}

std::optional<std::string> NetcdfFile::find_text_attribute(int variable, const std::string& name) const {
  const LibraryGuard guard(path_);
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(id_, variable, name.c_str(), &type, &length) != NC_NOERR) return std::nullopt;
  if (type == NC_STRING && length == 1) {
    char* text = nullptr;
    check(nc_get_att_string(id_, variable, name.c_str(), &text), "attribute " + name);
    std::string cleaned = clean_text(text == nullptr ? "" : text);
    nc_free_string(1, &text);
    return cleaned;
  }
  if (type != NC_CHAR) return std::nullopt;
  std::string text(length, '\0');
  check(nc_get_att_text(id_, variable, name.c_str(), text.data()), "attribute " + name);
  return clean_text(text);
}

std::size_t NetcdfFile::rows_per_read(const NetcdfVariable& variable) const {
  constexpr std::size_t values_in_cache = 1 << 18;
  if (variable.shape.empty() || variable.is_chunked) return std::max<std::size_t>(variable.size(), 1);
  const std::size_t n_rows = std::max<std::size_t>(variable.shape[0], 1);
  return std::max<std::size_t>(1, values_in_cache / std::max<std::size_t>(1, variable.size() / n_rows));
}

bool NetcdfFile::read_int32(const NetcdfVariable& variable, Rows rows, std::span<std::int32_t> values) const {
  if (values.empty()) return true;
  const LibraryGuard guard(path_);
  const Part part = make_part(variable, rows);
  assert(values.size() == part.size());
  const int status = nc_get_vara_int(id_, variable.id, part.start.data(), part.count.data(), values.data());
  if (status == NC_ERANGE) return false;
  check(status, "variable " + variable.name);
  return true;
}

void NetcdfFile::read_double(const NetcdfVariable& variable, Rows rows, std::span<double> values) const {
  if (values.empty()) return;
  const LibraryGuard guard(path_);
  const Part part = make_part(variable, rows);
  assert(values.size() == part.size());
  check(nc_get_vara_double(id_, variable.id, part.start.data(), part.count.data(), values.data()),
        "variable " + variable.name);
}

void NetcdfFile::read_int64(const NetcdfVariable& variable, Rows rows, std::span<std::int64_t> values) const {
  if (values.empty()) return;
  const LibraryGuard guard(path_);
  const Part part = make_part(variable, rows);
  assert(values.size() == part.size());
  static_assert(sizeof(long long) == sizeof(std::int64_t));
  check(nc_get_vara_longlong(id_, variable.id, part.start.data(), part.count.data(),
                             reinterpret_cast<long long*>(values.data())),
        "variable " + variable.name);
}

void NetcdfFile::read_text(const NetcdfVariable& variable, Rows rows, std::span<char> values) const {
  if (values.empty()) return;
  const LibraryGuard guard(path_);
  const Part part = make_part(variable, rows);
  assert(values.size() == part.size());
  check(nc_get_vara_text(id_, variable.id, part.start.data(), part.count.data(), values.data()),
        "variable " + variable.name);
}

void NetcdfFile::read_int64(const NetcdfVariable& variable, std::span<std::int64_t> values) const {
  assert(values.size() == variable.size());
  read_int64(variable, {0, variable.shape.empty() ? 1 : variable.shape[0]}, values);
}

void NetcdfFile::read_double(const NetcdfVariable& variable, std::span<double> values) const {
  assert(values.size() == variable.size());
  if (values.empty()) return;
  const LibraryGuard guard(path_);
  check(nc_get_var_double(id_, variable.id, values.data()), "variable " + variable.name);
}

std::vector<std::string> NetcdfFile::read_stored_texts(const NetcdfVariable& variable) const {
  if (!variable.is_text || variable.shape.size() < 2)
    fail("variable " + variable.name + " is not a list of texts");
  const LibraryGuard guard(path_);
  std::string all(variable.size(), '\0');
  if (!all.empty()) check(nc_get_var_text(id_, variable.id, all.data()), "variable " + variable.name);
  return split_texts(all, variable.shape.back());
}

std::vector<std::string> NetcdfFile::read_texts(const NetcdfVariable& variable) const {
  std::vector<std::string> texts = read_stored_texts(variable);
  for (std::string& text : texts) text = clean_text(text);
  return texts;
}

std::vector<std::string> split_texts(std::string_view rows, std::size_t width) {
  std::vector<std::string> texts;
  for (std::size_t begin = 0; width > 0 && begin + width <= rows.size(); begin += width) {
    const std::string_view stored = rows.substr(begin, width);
    texts.emplace_back(stored.substr(0, stored.find('\0')));
  }
  return texts;
}

}  // namespace contactsim
