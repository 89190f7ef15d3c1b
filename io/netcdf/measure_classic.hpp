// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace contactsim {

/// What a classic netCDF file takes [bytes].
struct FileBytes {
  std::uint64_t start = 0;   ///< without records
  std::uint64_t record = 0;  ///< of each record
};

/// The size of an open classic file by its definitions, whether its data are written or not.
/// Source: netCDF User's Guide, appendix B, "File Format Specifications".
///   id        of netCDF
///   is_large  CDF-5 in place of CDF-2
FileBytes measure_classic(int id, bool is_large);

}  // namespace contactsim
