// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// Reads the header of a classic netCDF file (CDF-1, CDF-2 or CDF-5) and compares it with the size of the
/// file, because netCDF reads the missing end of a cut-off file as zeros and trusts every count of a damaged
/// header. Throws FileError when the header is damaged or implies more bytes than there are.
/// Source: netCDF User's Guide, appendix B, "File Format Specifications".
void check_classic_layout(const std::string& path);

}  // namespace contactsim
