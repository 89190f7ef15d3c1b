// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/measure_classic.hpp"

#include <netcdf.h>

#include <array>
#include <cstring>

namespace contactsim {

namespace {

using Name = std::array<char, NC_MAX_NAME + 1>;

/// Sums up the header and the data of one file. netCDF refuses none of its questions: what is asked for is
/// there.
class Measure {
 public:
  Measure(int id, bool is_large) : id_(id), n_count_bytes_(is_large ? 8 : 4) {}

  FileBytes file() const;

 private:
  static std::uint64_t padded(std::uint64_t n_bytes) { return (n_bytes + 3) / 4 * 4; }
  std::uint64_t name(const Name& text) const { return n_count_bytes_ + padded(std::strlen(text.data())); }
  std::uint64_t list() const { return 4 + n_count_bytes_; }  // its tag and its length
  std::uint64_t type_size(nc_type type) const;
  std::uint64_t dimensions(int n) const;
  std::uint64_t attributes(int variable, int n) const;
  /// Adds a variable: its part of the header, and its data. Returns the bytes of its records that only pad
  /// them.
  std::uint64_t add_variable(int variable, FileBytes& bytes) const;

  int id_;
  std::uint64_t n_count_bytes_;
};

std::uint64_t Measure::type_size(nc_type type) const {
  std::size_t size = 0;
  nc_inq_type(id_, type, nullptr, &size);
  return size;
}

std::uint64_t Measure::dimensions(int n) const {
  std::uint64_t bytes = list();
  for (int dimension = 0; dimension < n; ++dimension) {
    Name text{};
    nc_inq_dimname(id_, dimension, text.data());
    bytes += name(text) + n_count_bytes_;
  }
  return bytes;
}

std::uint64_t Measure::attributes(int variable, int n) const {
  std::uint64_t bytes = list();
  for (int attribute = 0; attribute < n; ++attribute) {
    Name text{};
    nc_type type = NC_NAT;
    std::size_t length = 0;
    nc_inq_attname(id_, variable, attribute, text.data());
    nc_inq_att(id_, variable, text.data(), &type, &length);
    bytes += name(text) + 4 + n_count_bytes_ + padded(length * type_size(type));
  }
  return bytes;
}

std::uint64_t Measure::add_variable(int variable, FileBytes& bytes) const {
  Name text{};
  nc_type type = NC_NAT;
  int n_dimensions = 0, n_attributes = 0, records = -1;
  std::array<int, NC_MAX_VAR_DIMS> ids{};
  nc_inq_var(id_, variable, text.data(), &type, &n_dimensions, ids.data(), &n_attributes);
  nc_inq_unlimdim(id_, &records);
  std::uint64_t n_data = type_size(type);
  for (int i = 0; i < n_dimensions; ++i) {
    std::size_t length = 0;
    nc_inq_dimlen(id_, ids[static_cast<std::size_t>(i)], &length);
    if (ids[static_cast<std::size_t>(i)] != records) n_data *= length;
  }
  constexpr std::uint64_t type_bytes = 4, begin_bytes = 8;
  bytes.start += name(text) + n_count_bytes_ * (1 + static_cast<std::uint64_t>(n_dimensions)) +
                 attributes(variable, n_attributes) + type_bytes + n_count_bytes_ + begin_bytes;
  const bool has_records = n_dimensions > 0 && ids[0] == records;
  (has_records ? bytes.record : bytes.start) += padded(n_data);
  return has_records ? padded(n_data) - n_data : 0;
}

FileBytes Measure::file() const {
  constexpr std::uint64_t magic_bytes = 4;
  int n_dimensions = 0, n_variables = 0, n_attributes = 0;
  nc_inq(id_, &n_dimensions, &n_variables, &n_attributes, nullptr);
  FileBytes bytes{
      magic_bytes + n_count_bytes_ + dimensions(n_dimensions) + attributes(NC_GLOBAL, n_attributes) + list(),
      0};
  std::uint64_t n_padding = 0;
  int n_with_records = 0;
  for (int variable = 0; variable < n_variables; ++variable) {
    const std::uint64_t before = bytes.record;
    n_padding += add_variable(variable, bytes);
    n_with_records += bytes.record > before ? 1 : 0;
  }
  // Records of one variable alone are not padded.
  if (n_with_records == 1) bytes.record -= n_padding;
  return bytes;
}

}  // namespace

FileBytes measure_classic(int id, bool is_large) { return Measure(id, is_large).file(); }

}  // namespace contactsim
