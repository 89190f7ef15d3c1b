// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/index_arrays.hpp"

#include <netcdf.h>

#include "support/catch.hpp"
#include "support/netcdf_check.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using contactsim::test::check;
using contactsim::test::TemporaryDirectory;

namespace {

// Writes the numbers as rows of `columns` values of the type and reads them back.
IndexArray round_trip(const std::vector<long long>& numbers, std::size_t columns, std::uint32_t limit,
                      std::vector<std::uint32_t>& positions, nc_type type = NC_INT) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("numbers.nc");
  int file = 0, variable = 0, dimensions[2];
  check(nc_create(path.c_str(), NC_64BIT_DATA, &file));
  check(nc_def_dim(file, "rows", numbers.size() / columns, &dimensions[0]));
  check(nc_def_dim(file, "columns", columns, &dimensions[1]));
  check(nc_def_var(file, "numbers", type, columns == 1 ? 1 : 2, dimensions, &variable));
  check(nc_enddef(file));
  check(nc_put_var_longlong(file, variable, numbers.data()));
  check(nc_close(file));
  const ExodusFile opened(path);
  positions.clear();
  return read_positions(opened, *opened.find_variable("numbers"), limit, positions);
}

}  // namespace

TEST_CASE("numbers from one become positions from zero", "[io][index]") {
  const nc_type type = GENERATE(NC_INT, NC_INT64, NC_UINT);
  std::vector<std::uint32_t> positions;
  const IndexArray found = round_trip({3, 1, 2, 5}, 2, 5, positions, type);
  CHECK(positions == std::vector<std::uint32_t>{2, 0, 1, 4});
  CHECK(!found.bad);
  CHECK(!found.has_repeats);
}

TEST_CASE("the first number out of range is found, wherever it is", "[io][index]") {
  // Longer than what is read at once.
  std::vector<long long> numbers(600000, 7);
  const std::size_t at =
      GENERATE(std::size_t{0}, std::size_t{262143}, std::size_t{262144}, std::size_t{599999});
  const long long value = GENERATE(0, -1, 8, 2147483647LL, -2147483648LL);
  numbers[at] = value;
  numbers.back() = value;
  std::vector<std::uint32_t> positions;
  const IndexArray found = round_trip(numbers, 1, 7, positions);
  REQUIRE(found.bad);
  CHECK(found.bad->position == at);
  CHECK(found.bad->value == value);
}

TEST_CASE("a number beyond 32 bits is found and reported", "[io][index]") {
  std::vector<std::uint32_t> positions;
  const IndexArray found = round_trip({1, 2, 4294967297LL, 0}, 1, 5, positions, NC_INT64);
  REQUIRE(found.bad);
  CHECK(found.bad->position == 2);
  CHECK(found.bad->value == 4294967297LL);
}

TEST_CASE("repeats count within a row only", "[io][index]") {
  std::vector<std::uint32_t> positions;
  CHECK(!round_trip({1, 2, 3, 1, 2, 3}, 3, 3, positions).has_repeats);
  CHECK(round_trip({1, 2, 3, 1, 2, 1}, 3, 3, positions).has_repeats);
  CHECK(!round_trip({1, 1, 1}, 1, 3, positions).has_repeats);
  std::vector<long long> wide(20 * 1000);
  for (std::size_t i = 0; i < wide.size(); ++i) wide[i] = static_cast<long long>(i % 20) + 1;
  CHECK(!round_trip(wide, 20, 20, positions).has_repeats);
  wide[wide.size() - 20] = 20;
  CHECK(round_trip(wide, 20, 20, positions).has_repeats);
}
