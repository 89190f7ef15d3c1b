// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/files/output_place.hpp"
#include "io/netcdf/measure_classic.hpp"
#include "io/netcdf/netcdf_layout.hpp"

namespace contactsim {

/// A netCDF file being written: first all definitions, then all data but those of records, which RecordFile
/// writes. It has a temporary name until it is committed, so that nobody ever reads half of it. Every member
/// throws FileError with the final path when the system or netCDF refuses.
class NetcdfOutput {
 public:
  /// Attributes of the whole file are given to this in place of a variable.
  static constexpr int global = -1;
  /// Length of the record dimension.
  static constexpr std::size_t unlimited = 0;
  /// The most bytes of one variable, or of one record of it, that a file which is not `large` may have.
  /// Source: netCDF User's Guide, appendix B, note on vsize.
  static constexpr std::size_t largest_plain_variable = 0xfffffffcu;

  /// large  some variable passes largest_plain_variable or has 64-bit integers: CDF-5 in place of CDF-2
  NetcdfOutput(std::string path, bool large);
  /// Definitions alone, in memory, to be measured: not to be written.
  explicit NetcdfOutput(bool large);
  /// Removes what was not committed.
  ~NetcdfOutput();
  NetcdfOutput(const NetcdfOutput&) = delete;
  NetcdfOutput& operator=(const NetcdfOutput&) = delete;

  int define_dimension(const std::string& name, std::size_t length);
  int define_variable(const std::string& name, NetcdfType type, const std::vector<int>& dimensions);
  void set_text(int variable, const std::string& attribute, const std::string& text);
  void set_number(int variable, const std::string& attribute, NetcdfType type, double value);
  void set_integer(int variable, const std::string& attribute, NetcdfType type, std::int64_t value);
  void set_attribute(int variable, const NetcdfAttribute& attribute);
  /// Defines all that a layout says; the variables have their positions in it for numbers. Dimensions of no
  /// length must be unlimited.
  void define(const NetcdfLayout& layout);
  /// What the file takes, by its definitions.
  FileBytes measure() const { return measure_classic(id_, is_large_); }
  void end_definitions();

  void write(int variable, std::span<const std::int32_t> values);
  void write(int variable, std::span<const std::int64_t> values);
  void write(int variable, std::span<const double> values);
  /// Rows of `width` characters, padded with NUL; longer texts are cut.
  void write(int variable, std::size_t width, const std::vector<std::string>& texts);

  /// Writes values of any type to a variable, or to one record of it. Precondition: as many as belong there.
  void write(int variable, std::optional<std::size_t> record, const NetcdfValues& values);

  /// Closes the file and gives it its name.
  void commit();

 private:
  void create(const std::string& path, int mode);
  void check(int status, const std::string& what) const;

  std::string path_;
  OutputPlace place_;
  int id_ = -1;
  bool is_large_ = false, is_open_ = false;
};

}  // namespace contactsim
