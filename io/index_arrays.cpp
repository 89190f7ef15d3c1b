// SPDX-License-Identifier: BSD-3-Clause
#include "io/index_arrays.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace contactsim {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Values of one tile stay in the first-level cache between the two looks at them.
constexpr std::size_t tile_values = 4096;

// Zero and negative numbers wrap to large positions, so one comparison finds all that is wrong.
bool shift_to_positions(std::span<std::uint32_t> numbers, std::uint32_t limit) {
  std::uint32_t is_bad = 0;
  for (std::uint32_t& number : numbers) {
    number -= 1;
    is_bad |= number >= limit ? 1u : 0u;
  }
  return is_bad != 0;
}

bool has_repeat(std::span<const std::uint32_t> row) {
  std::uint32_t found = 0;
  for (std::size_t i = 1; i < row.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) found |= row[i] == row[j] ? 1u : 0u;
  }
  return found != 0;
}

bool any_row_repeats(std::span<const std::uint32_t> tile, std::size_t columns) {
  for (std::size_t row = 0; row < tile.size(); row += columns) {
    if (has_repeat(tile.subspan(row, columns))) return true;
  }
  return false;
}

std::size_t first_beyond(std::span<const std::uint32_t> positions, std::uint32_t limit) {
  const auto found = std::find_if(positions.begin(), positions.end(),
                                  [&](std::uint32_t position) { return position >= limit; });
  return static_cast<std::size_t>(found - positions.begin());
}

// For the rare file whose numbers pass 32 bits: which one is it?
BadNumber find_wide(const NetcdfFile& file, const NetcdfVariable& variable, std::uint32_t limit) {
  std::vector<std::int64_t> numbers(variable.size());
  file.read_int64(variable, numbers);
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&](std::int64_t n) { return n < 1 || n > std::int64_t{limit}; });
  if (found == numbers.end()) file.fail("variable " + variable.name + " holds numbers that are not integers");
  return {static_cast<std::size_t>(found - numbers.begin()), *found};
}

}  // namespace

IndexArray read_positions(const NetcdfFile& file, const NetcdfVariable& variable, std::size_t columns,
                          std::uint32_t limit, std::span<std::uint32_t> positions) {
  assert(columns > 0 && positions.size() % columns == 0);
  // The signed and the unsigned type of one width may name the same memory.
  const std::span<std::int32_t> numbers(reinterpret_cast<std::int32_t*>(positions.data()), positions.size());
  if (!file.read_int32(variable, numbers)) return {find_wide(file, variable, limit), false};

  const std::size_t tile_size = std::max<std::size_t>(1, tile_values / columns) * columns;
  const auto n_tiles = static_cast<std::ptrdiff_t>((positions.size() + tile_size - 1) / tile_size);
  std::size_t first_bad = none;
  bool has_repeats = false;
#pragma omp parallel for schedule(static) reduction(min : first_bad) reduction(|| : has_repeats)
  for (std::ptrdiff_t t = 0; t < n_tiles; ++t) {
    const std::size_t begin = static_cast<std::size_t>(t) * tile_size;
    const auto tile = positions.subspan(begin, std::min(tile_size, positions.size() - begin));
    if (shift_to_positions(tile, limit)) first_bad = std::min(first_bad, begin + first_beyond(tile, limit));
    has_repeats = has_repeats || (columns > 1 && any_row_repeats(tile, columns));
  }
  if (first_bad == none) return {std::nullopt, has_repeats};
  return {BadNumber{first_bad, static_cast<std::int32_t>(positions[first_bad] + 1)}, has_repeats};
}

}  // namespace contactsim
