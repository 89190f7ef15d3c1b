// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/indices.hpp"
#include "io/pieces/exodus_file.hpp"

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

/// Reads numbers 1..limit as positions from 0, appending them to `positions`, which may hold anything when
/// some number is bad.
///   variable   [n] or [n_rows x n_columns], at most 32 columns
///   limit      at most 2^31 - 1
///   Index      std::uint32_t or NodeIndex
template <class Index>
IndexArray read_positions(const ExodusFile& file, const NetcdfVariable& variable, std::uint32_t limit,
                          std::vector<Index>& positions);

extern template IndexArray read_positions(const ExodusFile&, const NetcdfVariable&, std::uint32_t,
                                          std::vector<std::uint32_t>&);
extern template IndexArray read_positions(const ExodusFile&, const NetcdfVariable&, std::uint32_t,
                                          std::vector<NodeIndex>&);

}  // namespace contactsim
