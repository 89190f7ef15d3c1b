// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace contactsim {

/// A line of a CSV file.
struct CsvLine {
  int number = 0;  ///< of the text line that it begins on, from 1
  std::vector<std::string> fields;
};

/// The lines of a CSV file; empty ones are left out. Fields in quotes may hold commas, line ends and doubled
/// quotes; blanks around the others do not count. Source: RFC 4180.
std::vector<CsvLine> split_csv(std::string_view text);

}  // namespace contactsim
