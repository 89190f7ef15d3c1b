// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "io/netcdf_file.hpp"

namespace contactsim {

/// A number of a file that is outside 1..limit.
struct BadNumber {
  std::size_t position = 0;  ///< in the array, from 0
  std::int64_t value = 0;    ///< as the file has it
};

/// What one pass over an array of node or element numbers finds.
struct IndexArray {
  std::optional<BadNumber> bad;  ///< the first one
  bool has_repeats = false;      ///< some row holds a number twice
};

/// Reads numbers 1..limit as positions from 0.
///   columns    numbers per row; repeats are looked for within rows
///   limit      at most 2^31 - 1
///   positions  [variable.size()]  undefined when some number is bad
IndexArray read_positions(const NetcdfFile& file, const NetcdfVariable& variable, std::size_t columns,
                          std::uint32_t limit, std::span<std::uint32_t> positions);

}  // namespace contactsim
