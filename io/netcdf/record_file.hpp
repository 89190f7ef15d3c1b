// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/files/file_descriptor.hpp"
#include "io/netcdf/classic_layout.hpp"

namespace contactsim {

/// Which values of an array a variable takes: values[first], values[first + stride], ...
struct Stride {
  std::size_t first = 0, stride = 1;
};

/// A classic netCDF file that NetcdfOutput made, as its records are appended. The values of a record are in
/// the file before its number counts it, so that however the process ends every reader finds the records that
/// were ended, whole: netCDF itself promises no order in which its buffers reach the file. Every member
/// throws FileError when the system refuses; the file is then closed with the records that were ended.
/// Source: netCDF User's Guide, appendix B, "File Format Specifications".
class RecordFile {
 public:
  /// Opens the file; it is the one that is written even when it gets another name.
  explicit RecordFile(std::string path);
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// Sets a variable of doubles, or a part of it, in the record after the last. Precondition: there is such a
  /// variable, and the values that are taken fit into it.
  ///   first  position in the variable of the first value
  void write(const std::string& variable, std::span<const double> values, Stride stride = {},
             std::size_t first = 0);

  /// Ends the record: from now on it counts.
  void end_record();

  std::uint64_t n_records() const { return layout_.n_records; }

 private:
  void write_bytes(std::span<const char> bytes, std::uint64_t position);
  [[noreturn]] void fail(int error);

  std::string path_;
  RecordLayout layout_;
  FileDescriptor file_;
  std::vector<char> buffer_;
};

}  // namespace contactsim
