// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "io/output_place.hpp"

namespace contactsim {

enum class NetcdfType : std::uint8_t { text, int32, int64, float32, float64 };

/// A netCDF file being written: first all definitions, then all data. It has a temporary name until it is
/// committed or published, so that nobody ever reads half of it. Every member throws FileError with the final
/// path when the system or netCDF refuses.
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
  /// Removes what was neither committed nor published; ends a published file at its last sync.
  ~NetcdfOutput();
  NetcdfOutput(const NetcdfOutput&) = delete;
  NetcdfOutput& operator=(const NetcdfOutput&) = delete;

  int define_dimension(const std::string& name, std::size_t length);
  int define_variable(const std::string& name, NetcdfType type, const std::vector<int>& dimensions);
  void set_text(int variable, const std::string& attribute, const std::string& text);
  void set_number(int variable, const std::string& attribute, NetcdfType type, double value);
  void set_integer(int variable, const std::string& attribute, NetcdfType type, std::int64_t value);
  void end_definitions();

  void write(int variable, std::span<const std::int32_t> values);
  void write(int variable, std::span<const std::int64_t> values);
  void write(int variable, std::span<const double> values);
  /// Rows of `width` characters, padded with NUL; longer texts are cut.
  void write(int variable, std::size_t width, const std::vector<std::string>& texts);
  /// The values of one record, from 0.
  void write_record(int variable, std::size_t record, std::span<const double> values);

  /// Closes the file and gives it its name.
  void commit();

  /// Gives the file its name and leaves it open for records.
  void publish();
  /// Puts all records so far where other programs see them. What is not synced does not count as written:
  /// however the process ends, the file holds the records of the last sync.
  void sync();
  /// Closes a published file as of its last sync; nothing can be written to it any more.
  void close_at_last_sync();

 private:
  void check(int status, const std::string& what) const;
  void restore_record_count();

  std::string path_;
  OutputPlace place_;
  int id_ = -1;
  bool is_open_ = false, is_published_ = false, is_large_ = false;
  std::size_t n_written_ = 0, n_synced_ = 0;  // records
  std::fstream header_;                       // of a published file, wherever its name goes
};

}  // namespace contactsim
