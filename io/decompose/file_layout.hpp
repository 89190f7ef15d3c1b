// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "io/netcdf/netcdf_layout.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// What can be written of a layout as a classic file: time_step alone is unlimited, and dimensions without
/// length are left out with the variables along them.
NetcdfLayout make_writable(const NetcdfLayout& layout);

/// Whether a layout needs CDF-5 in place of CDF-2.
bool needs_large_file(const NetcdfLayout& layout);

/// Whether a variable of a layout has a value for each time.
bool is_record(const NetcdfLayout& layout, const NetcdfDefinition& variable);

/// Asks for the values of a variable of a file: all at once, or record after record.
///   use  (record, values); no record where the variable has none
template <class Use>
void read_in_parts(const ExodusFile& file, const NetcdfDefinition& definition, bool has_records,
                   const Use& use) {
  const NetcdfVariable variable = file.find_variable(definition.name).value();
  const std::size_t n = variable.shape.empty() ? 1 : variable.shape[0];
  if (!has_records)
    return use(std::optional<std::size_t>(), file.read_values(variable, definition.type, {0, n}));
  for (std::size_t record = 0; record < n; ++record)
    use(std::optional(record), file.read_values(variable, definition.type, {record, 1}));
}

}  // namespace contactsim
