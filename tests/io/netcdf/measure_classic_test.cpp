// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/measure_classic.hpp"

#include <netcdf.h>

#include <vector>

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

struct MeasuredVariable {
  const char* name;
  nc_type type;
  bool has_records;
  std::size_t length;  ///< of a dimension of its own; 0: none
};

/// What a file is said to take, and what it takes with this many records of zeros.
void check_measure(const std::vector<MeasuredVariable>& variables, std::size_t n_records, int format) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.nc");
  int id = 0, records = 0;
  REQUIRE(nc_create(path.c_str(), NC_CLOBBER | format, &id) == NC_NOERR);
  nc_def_dim(id, "time", NC_UNLIMITED, &records);
  nc_put_att_text(id, NC_GLOBAL, "title", 5, "a run");
  std::vector<int> variable_ids;
  for (const MeasuredVariable& one : variables) {
    std::vector<int> dimensions;
    if (one.has_records) dimensions.push_back(records);
    if (one.length > 0) {
      const std::string name = "n_" + std::string(one.name);
      nc_def_dim(id, name.c_str(), one.length, &dimensions.emplace_back());
    }
    const int rank = static_cast<int>(dimensions.size());
    nc_def_var(id, one.name, one.type, rank, dimensions.data(), &variable_ids.emplace_back());
    const double bounds[] = {0.0, 1.0};
    nc_put_att_double(id, variable_ids.back(), "bounds", NC_DOUBLE, 2, bounds);
  }
  const FileBytes said = measure_classic(id, format == NC_64BIT_DATA);
  REQUIRE(nc_enddef(id) == NC_NOERR);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (!variables[i].has_records) continue;
    const std::size_t start[] = {0, 0}, count[] = {n_records, variables[i].length};
    const std::vector<char> zeros(8 * n_records * (variables[i].length + 1), 0);
    if (n_records > 0) CHECK(nc_put_vara(id, variable_ids[i], start, count, zeros.data()) == NC_NOERR);
  }
  REQUIRE(nc_close(id) == NC_NOERR);
  CHECK(said.start + n_records * said.record == read_bytes(path).size());
}

}  // namespace

TEST_CASE("a classic file takes what is said of it, to the byte", "[io][netcdf]") {
  const int format = GENERATE(NC_64BIT_OFFSET, NC_64BIT_DATA);
  const std::size_t n_records = GENERATE(0, 1, 3);
  check_measure({}, 0, format);
  check_measure({{"ids", NC_INT, false, 3}, {"name_of_it", NC_CHAR, false, 7}, {"x", NC_DOUBLE, false, 0}}, 0,
                format);
  check_measure(
      {{"ids", NC_INT, false, 3}, {"time_whole", NC_DOUBLE, true, 0}, {"value", NC_DOUBLE, true, 5}},
      n_records, format);
  check_measure({{"word", NC_CHAR, true, 7}, {"small", NC_SHORT, true, 3}, {"t", NC_DOUBLE, true, 0}},
                n_records, format);
}

TEST_CASE("records of one variable alone are not padded", "[io][netcdf]") {
  const int format = GENERATE(NC_64BIT_OFFSET, NC_64BIT_DATA);
  check_measure({{"word", NC_CHAR, true, 7}, {"ids", NC_INT, false, 3}}, 4, format);
  check_measure({{"small", NC_SHORT, true, 3}}, 4, format);
}
