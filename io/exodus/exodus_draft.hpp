// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "io/netcdf/netcdf_output.hpp"

namespace contactsim {

/// How the things of one Exodus file are stored.
struct ExodusFormat {
  bool is_large = false;         ///< CDF-5 in place of CDF-2
  bool has_wide_ids = false;     ///< ids and maps of 64 bits; large files only
  std::size_t name_length = 32;  ///< of the longest name
};

/// The rows of an id array.
struct IdRows {
  std::vector<std::int64_t> ids;
  std::vector<std::int32_t> status;  ///< 1, or 0 for what is empty
  std::vector<std::string> names;
};

/// The variables of an Exodus file with what will be in them: netCDF wants all definitions before the first
/// data, people want each variable in one place. Data are made when they are written, one variable at a time.
/// Throws FileError as NetcdfOutput does.
class ExodusDraft {
 public:
  ExodusDraft(NetcdfOutput& file, const ExodusFormat& format) : file_(file), format_(format) {}

  NetcdfOutput& file() { return file_; }
  const ExodusFormat& format() const { return format_; }

  int add_dimension(const std::string& name, std::size_t length);
  /// Precondition: the dimension has been added.
  int dimension(const std::string& name) const { return dimensions_.at(name); }

  int add_integers(const std::string& name, const std::vector<int>& dimensions,
                   std::function<std::vector<std::int32_t>()> make);
  /// Numbers given by users, as wide as the format says.
  int add_ids(const std::string& name, int dimension, std::function<std::vector<std::int64_t>()> make);
  int add_reals(const std::string& name, const std::vector<int>& dimensions,
                std::function<std::vector<double>()> make);
  /// Texts in rows as long as the last dimension, which is given by name; the last character stays NUL.
  int add_texts(const std::string& name, std::vector<int> dimensions, const std::string& width,
                std::vector<std::string> texts);
  /// <prefix>_prop1, _status and _names over a dimension of the name; nothing when there are no rows.
  void add_id_rows(const std::string& count, const std::string& prefix, const IdRows& rows);

  /// Ends the definitions and writes all data.
  void write();

 private:
  NetcdfOutput& file_;
  ExodusFormat format_;
  std::map<std::string, int> dimensions_;
  std::map<std::string, std::size_t> lengths_;
  std::vector<std::function<void()>> writes_;
};

}  // namespace contactsim
