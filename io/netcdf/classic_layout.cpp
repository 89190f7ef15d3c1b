// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/classic_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/errors.hpp"
#include "io/netcdf/clean_text.hpp"

namespace contactsim {

namespace {

constexpr std::uint64_t dimension_tag = 10, variable_tag = 11, attribute_tag = 12;

// NC_MAX_NAME of netCDF, which copies names into buffers of that size.
constexpr std::uint64_t longest_name = 256;

// Bytes of the types 1..11: byte, char, short, int, float, double, ubyte, ushort, uint, int64, uint64.
constexpr std::uint64_t type_sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};

struct ClassicVariable {
  std::string name;
  bool is_record = false;
  std::uint64_t n_bytes = 0;  // of one record for record variables
  std::uint64_t begin = 0;
};

struct ClassicHeader {
  std::optional<std::uint64_t> n_records;  // absent: the file was being streamed
  int n_count_bytes = 4;
  std::vector<ClassicVariable> variables;
  std::uint64_t n_bytes = 0;
};

class HeaderReader {
 public:
  explicit HeaderReader(const std::string& path)
      : path_(path), file_(path, std::ios::binary), file_size_(std::filesystem::file_size(path)) {}

  ClassicHeader read();
  std::uint64_t file_size() const { return file_size_; }

 private:
  std::uint64_t read_number(int n_bytes);
  std::uint64_t read_count() { return read_number(count_bytes_); }
  std::uint64_t read_list(std::uint64_t tag);
  std::string read_name();
  void skip(std::uint64_t n_bytes);
  void read_attributes();
  ClassicVariable read_variable();
  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(path_, fmt::format("damaged netCDF header: {} (at byte {})", what, position_));
  }

  std::string path_;
  std::ifstream file_;
  std::uint64_t file_size_;
  std::uint64_t position_ = 0;
  int version_ = 0;
  int count_bytes_ = 4;
  std::vector<std::uint64_t> dimensions_;  // length, 0 for the record dimension
};

std::uint64_t padded(std::uint64_t n_bytes) { return (n_bytes + 3) / 4 * 4; }

// Sizes come from the file, so products and sums may overflow; past the end of any file they are all alike.
constexpr std::uint64_t too_large = std::numeric_limits<std::uint64_t>::max() / 4;

std::uint64_t multiply(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > too_large / a ? too_large : a * b;
}

std::uint64_t add(std::uint64_t a, std::uint64_t b) {
  return a > too_large || b > too_large - a ? too_large : a + b;
}

std::uint64_t HeaderReader::read_number(int n_bytes) {
  std::uint64_t number = 0;
  for (int i = 0; i < n_bytes; ++i) {
    const int byte = file_.get();
    if (byte == std::ifstream::traits_type::eof()) fail("the file ends inside it");
    number = number << 8 | static_cast<std::uint64_t>(byte);
    ++position_;
  }
  return number;
}

void HeaderReader::skip(std::uint64_t n_bytes) {
  if (n_bytes > file_size_ - position_) fail("the file ends inside it");
  file_.ignore(static_cast<std::streamsize>(n_bytes));
  position_ += n_bytes;
}

// Returns the number of items of a list; each takes at least four bytes, so that a wild count is found here.
std::uint64_t HeaderReader::read_list(std::uint64_t tag) {
  const std::uint64_t found = read_number(4);
  const std::uint64_t n_items = read_count();
  if (found == 0 && n_items == 0) return 0;
  if (found != tag) fail(fmt::format("a list begins with {} in place of {}", found, tag));
  if (n_items > (file_size_ - position_) / 4) fail(fmt::format("a list claims {} items", n_items));
  return n_items;
}

std::string HeaderReader::read_name() {
  const std::uint64_t length = read_count();
  if (length > longest_name) fail(fmt::format("a name claims {} characters", length));
  if (length > file_size_ - position_) fail("the file ends inside it");
  std::string name(static_cast<std::size_t>(length), ' ');
  file_.read(name.data(), static_cast<std::streamsize>(length));
  position_ += length;
  skip(padded(length) - length);
  return name;
}

void HeaderReader::read_attributes() {
  const std::uint64_t n_attributes = read_list(attribute_tag);
  for (std::uint64_t i = 0; i < n_attributes; ++i) {
    const std::string name = clean_text(read_name());
    const std::uint64_t type = read_number(4);
    if (type == 0 || type >= std::size(type_sizes))
      fail(fmt::format("attribute {} is of type {}", name, type));
    skip(padded(multiply(read_count(), type_sizes[type])));
  }
}

ClassicVariable HeaderReader::read_variable() {
  ClassicVariable variable;
  variable.name = clean_text(read_name());
  const std::uint64_t rank = read_count();
  if (rank > (file_size_ - position_) / 4) fail(fmt::format("{} claims {} dimensions", variable.name, rank));
  std::uint64_t n_values = 1;
  for (std::uint64_t i = 0; i < rank; ++i) {
    const std::uint64_t dimension = read_count();
    if (dimension >= dimensions_.size())
      fail(fmt::format("{} has no dimension {}", variable.name, dimension));
    if (dimensions_[dimension] == 0) {
      if (i > 0) fail(fmt::format("{} has its records inside", variable.name));
      variable.is_record = true;
    } else {
      n_values = multiply(n_values, dimensions_[dimension]);
    }
  }
  read_attributes();
  const std::uint64_t type = read_number(4);
  if (type == 0 || type >= std::size(type_sizes)) fail(fmt::format("{} is of type {}", variable.name, type));
  variable.n_bytes = multiply(n_values, type_sizes[type]);
  read_count();  // The stored size wraps past 4 GiB; the one computed above does not.
  variable.begin = read_number(version_ == 1 ? 4 : 8);
  return variable;
}

ClassicHeader HeaderReader::read() {
  skip(3);
  version_ = static_cast<int>(read_number(1));
  if (version_ != 1 && version_ != 2 && version_ != 5) fail(fmt::format("unknown version {}", version_));
  count_bytes_ = version_ == 5 ? 8 : 4;
  ClassicHeader header;
  header.n_count_bytes = count_bytes_;
  const std::uint64_t n_records = read_count();
  const std::uint64_t streaming = version_ == 5 ? ~std::uint64_t{0} : 0xffffffffu;
  if (n_records != streaming) header.n_records = n_records;

  const std::uint64_t n_dimensions = read_list(dimension_tag);
  for (std::uint64_t i = 0; i < n_dimensions; ++i) {
    read_name();
    dimensions_.push_back(read_count());
  }
  read_attributes();
  const std::uint64_t n_variables = read_list(variable_tag);
  for (std::uint64_t i = 0; i < n_variables; ++i) header.variables.push_back(read_variable());
  header.n_bytes = position_;
  return header;
}

std::uint64_t record_bytes(const ClassicHeader& header) {
  std::uint64_t sum = 0, n_record_variables = 0, last = 0;
  for (const ClassicVariable& variable : header.variables) {
    if (!variable.is_record) continue;
    last = variable.n_bytes;
    sum = add(sum, padded(variable.n_bytes));
    ++n_record_variables;
  }
  return n_record_variables == 1 ? last : sum;
}

std::uint64_t end_of(const ClassicVariable& variable, const ClassicHeader& header,
                     std::uint64_t record_size) {
  if (!variable.is_record) return add(variable.begin, variable.n_bytes);
  if (header.n_records.value_or(0) == 0) return 0;
  return add(add(variable.begin, multiply(*header.n_records - 1, record_size)), variable.n_bytes);
}

}  // namespace

void check_classic_layout(const std::string& path) {
  HeaderReader reader(path);
  const ClassicHeader header = reader.read();
  const std::uint64_t record_size = record_bytes(header);
  for (const ClassicVariable& variable : header.variables) {
    if (variable.begin < header.n_bytes) {
      throw FileError(path, fmt::format("damaged netCDF header: {} begins inside it", variable.name));
    }
    const std::uint64_t end = end_of(variable, header, record_size);
    if (end <= reader.file_size()) continue;
    throw FileError(
        path, fmt::format("truncated: variable {} ends at byte {}, the file at byte {}", variable.name,
                          end == too_large ? "2^62 or later" : fmt::to_string(end), reader.file_size()));
  }
}

RecordLayout read_record_layout(const std::string& path) {
  const ClassicHeader header = HeaderReader(path).read();
  RecordLayout layout;
  layout.n_records = header.n_records.value_or(0);
  layout.n_count_bytes = header.n_count_bytes;
  layout.record_size = record_bytes(header);
  layout.begin = too_large;
  for (const ClassicVariable& variable : header.variables) {
    if (variable.is_record) layout.begin = std::min(layout.begin, variable.begin);
  }
  for (const ClassicVariable& variable : header.variables) {
    if (variable.is_record) layout.places[variable.name] = variable.begin - layout.begin;
  }
  return layout;
}

}  // namespace contactsim
