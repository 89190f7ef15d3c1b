// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace contactsim {

/// Reads the header of a classic netCDF file (CDF-1, CDF-2 or CDF-5) and compares it with the size of the
/// file, because netCDF reads the missing end of a cut-off file as zeros and trusts every count of a damaged
/// header. Throws FileError when the header is damaged or implies more bytes than there are.
/// Source: netCDF User's Guide, appendix B, "File Format Specifications".
void check_classic_layout(const std::string& path);

/// Where a classic file keeps its records: one after the other, each with all record variables.
struct RecordLayout {
  std::uint64_t n_records = 0;
  int n_count_bytes = 4;          ///< of the number of records, which begins at byte 4, big-endian
  std::uint64_t begin = 0;        ///< of the first record in the file [bytes]
  std::uint64_t record_size = 0;  ///< [bytes]
  std::map<std::string, std::uint64_t>
      places;  ///< of each record variable, from the begin of a record [bytes]
};

/// The layout that the header of a classic file states. Throws FileError when the header is damaged.
RecordLayout read_record_layout(const std::string& path);

}  // namespace contactsim
