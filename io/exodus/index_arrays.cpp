// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/index_arrays.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace contactsim {

namespace {

constexpr std::size_t max_columns = 32;

// Rows that are compared side by side: the compiler turns a loop over them into vector instructions.
constexpr std::size_t rows_abreast = 64;

// Zero and negative numbers wrap to large positions, so one comparison finds all that is wrong.
bool shift_to_positions(std::span<std::uint32_t> numbers, std::uint32_t limit) {
  std::uint32_t is_bad = 0;
  for (std::uint32_t& number : numbers) {
    number -= 1;
    is_bad |= number >= limit ? 1u : 0u;
  }
  return is_bad != 0;
}

// The last rows of the array may be fewer than 64; they are filled up with copies of the first.
bool any_repeats_abreast(std::span<const std::uint32_t> rows, std::size_t columns) {
  std::array<std::array<std::uint32_t, rows_abreast>, max_columns> by_column;
  const std::size_t n_rows = rows.size() / columns;
  for (std::size_t r = 0; r < rows_abreast; ++r) {
    const std::size_t row = r < n_rows ? r : 0;
    for (std::size_t c = 0; c < columns; ++c) by_column[c][r] = rows[row * columns + c];
  }
  std::array<std::uint32_t, rows_abreast> found{};
  for (std::size_t a = 1; a < columns; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      for (std::size_t r = 0; r < rows_abreast; ++r) found[r] |= by_column[a][r] == by_column[b][r] ? 1u : 0u;
    }
  }
  return std::any_of(found.begin(), found.end(), [](std::uint32_t f) { return f != 0; });
}

bool any_row_repeats(std::span<const std::uint32_t> rows, std::size_t columns) {
  if (columns < 2) return false;
  const std::size_t step = rows_abreast * columns;
  for (std::size_t begin = 0; begin < rows.size(); begin += step) {
    if (any_repeats_abreast(rows.subspan(begin, std::min(step, rows.size() - begin)), columns)) return true;
  }
  return false;
}

// For the rare file whose numbers pass 32 bits: which one is it?
BadNumber find_wide(const ExodusFile& file, const NetcdfVariable& variable, std::uint32_t limit) {
  std::vector<std::int64_t> numbers(variable.size());
  file.read_int64(variable, numbers);
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&](std::int64_t n) { return n < 1 || n > std::int64_t{limit}; });
  if (found == numbers.end()) file.fail("variable " + variable.name + " holds numbers that are not integers");
  return {static_cast<std::size_t>(found - numbers.begin()), *found};
}

BadNumber find_bad(std::span<const std::uint32_t> positions, std::size_t first, std::uint32_t limit) {
  const auto found =
      std::find_if(positions.begin(), positions.end(), [&](std::uint32_t p) { return p >= limit; });
  const auto offset = static_cast<std::size_t>(found - positions.begin());
  return {first + offset, static_cast<std::int32_t>(*found + 1)};
}

}  // namespace

template <class Index>
IndexArray read_positions(const ExodusFile& file, const NetcdfVariable& variable, std::uint32_t limit,
                          std::vector<Index>& positions) {
  static_assert(sizeof(Index) == sizeof(std::uint32_t));
  const std::size_t columns = variable.shape.size() == 2 ? variable.shape[1] : 1;
  const std::size_t n_rows = variable.shape[0], rows_per_read = file.rows_per_read(variable);
  assert(columns > 0 && columns <= max_columns);
  positions.reserve(positions.size() + n_rows * columns);
  IndexArray result;
  // A part is grown, read, shifted and checked while it is in the cache.
  for (std::size_t row = 0; row < n_rows; row += rows_per_read) {
    const std::size_t n_now = std::min(rows_per_read, n_rows - row), n_values = n_now * columns;
    positions.resize(positions.size() + n_values);
    Index* const begin = positions.data() + (positions.size() - n_values);
    // The signed and the unsigned type of one width may name the same memory.
    if (!file.read_int32(variable, {row, n_now}, {reinterpret_cast<std::int32_t*>(begin), n_values})) {
      return {find_wide(file, variable, limit), false};
    }
    const std::span<std::uint32_t> part(reinterpret_cast<std::uint32_t*>(begin), n_values);
    if (shift_to_positions(part, limit)) return {find_bad(part, row * columns, limit), false};
    result.has_repeats = result.has_repeats || any_row_repeats(part, columns);
  }
  return result;
}

template IndexArray read_positions(const ExodusFile&, const NetcdfVariable&, std::uint32_t,
                                   std::vector<std::uint32_t>&);
template IndexArray read_positions(const ExodusFile&, const NetcdfVariable&, std::uint32_t,
                                   std::vector<NodeIndex>&);

}  // namespace contactsim
