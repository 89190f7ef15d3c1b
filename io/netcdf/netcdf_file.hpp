// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/netcdf/netcdf_layout.hpp"

namespace contactsim {

/// A variable of an open netCDF file. Its size has been compared with the size of the file.
struct NetcdfVariable {
  int id = 0;
  std::string name;
  std::vector<std::size_t> shape;
  bool is_text = false;
  bool is_64_bit_integer = false;
  bool is_chunked = false;  ///< stored in pieces, perhaps compressed: reading a part may cost as much as all

  std::size_t size() const;  ///< product of the shape
};

/// Consecutive rows of a variable: positions along its first dimension.
struct Rows {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// A netCDF file of any format, open for reading. Every member throws FileError with the path when the file
/// is damaged.
class NetcdfFile {
 public:
  /// Throws FileError that calls the file what it is when it is not a whole netCDF file.
  explicit NetcdfFile(std::string path);
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  const std::string& path() const { return path_; }
  /// Throws FileError for this file.
  [[noreturn]] void fail(const std::string& what) const;

  /// Length of a dimension, 0 when there is none of the name.
  std::size_t dimension(const std::string& name) const;
  /// Throws when the file is too small to hold the variable.
  std::optional<NetcdfVariable> find_variable(const std::string& name) const;
  /// Names of all variables that begin with the prefix, in file order.
  std::vector<std::string> variable_names(std::string_view prefix) const;
  int n_groups() const;

  std::optional<double> find_global_number(const std::string& name) const;
  std::optional<std::string> find_global_text(const std::string& name) const;
  std::optional<std::int64_t> find_integer(const NetcdfVariable& variable,
                                           const std::string& attribute) const;
  std::optional<std::string> find_text(const NetcdfVariable& variable, const std::string& attribute) const;

  /// How many rows to read at a time so that they stay in the cache; all when parts are costly.
  std::size_t rows_per_read(const NetcdfVariable& variable) const;
  /// Reads some rows into a span of their size; false when some value does not fit.
  [[nodiscard]] bool read_int32(const NetcdfVariable& variable, Rows rows,
                                std::span<std::int32_t> values) const;
  void read_double(const NetcdfVariable& variable, Rows rows, std::span<double> values) const;
  void read_int64(const NetcdfVariable& variable, Rows rows, std::span<std::int64_t> values) const;
  void read_text(const NetcdfVariable& variable, Rows rows, std::span<char> values) const;
  /// Read a whole variable into a span of its size.
  void read_int64(const NetcdfVariable& variable, std::span<std::int64_t> values) const;
  void read_double(const NetcdfVariable& variable, std::span<double> values) const;
  /// Rows of a text variable n x length or m x n x length, cleaned (clean_text).
  std::vector<std::string> read_texts(const NetcdfVariable& variable) const;
  /// The same up to their NUL, with the blanks around them.
  std::vector<std::string> read_stored_texts(const NetcdfVariable& variable) const;

 private:
  void check(int status, const std::string& what) const;
  /// Throws when the file is too small for so many values of the variable's type.
  void check_fits(const NetcdfVariable& variable, std::span<const std::size_t> lengths) const;
  std::optional<std::string> find_text_attribute(int variable, const std::string& name) const;

  std::string path_;
  std::uint64_t file_size_ = 0;
  int id_ = -1;

  friend NetcdfLayout read_layout(const NetcdfFile& file);
};

/// Texts that stand in rows of a width, each up to its NUL, with the blanks around it.
std::vector<std::string> split_texts(std::string_view rows, std::size_t width);

}  // namespace contactsim
