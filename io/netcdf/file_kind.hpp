// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace contactsim {

/// What the first bytes of a file say it is.
enum class FileKind : std::uint8_t {
  classic,  ///< netCDF CDF-1, CDF-2 or CDF-5
  hdf5,     ///< netCDF-4
  other     ///< something that netCDF may yet know
};

/// Looks at a file before netCDF does, because netCDF has one error for everything that it does not know.
/// Throws FileError for what is missing, unreadable, a directory, not a regular file, empty, a git-lfs
/// pointer or a text file.
FileKind find_file_kind(const std::string& path);

}  // namespace contactsim
