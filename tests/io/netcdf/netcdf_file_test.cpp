// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/netcdf_file.hpp"

#include <netcdf.h>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/netcdf_check.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A netCDF file that a function defines and fills.
class SomeFile {
 public:
  template <class Fill>
  SomeFile(int format, Fill fill) {
    int file = 0;
    check(nc_create(path().c_str(), format, &file));
    fill(file);
    check(nc_close(file));
  }
  std::string path() const { return directory_.file("a.nc"); }

 private:
  TemporaryDirectory directory_;
};

int define(int file, const char* name, nc_type type, std::vector<int> dimensions) {
  int variable = 0;
  check(nc_def_var(file, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &variable));
  return variable;
}

int define_dimension(int file, const char* name, std::size_t length) {
  int dimension = 0;
  check(nc_def_dim(file, name, length, &dimension));
  return dimension;
}

/// Three rows of two numbers, one of them too large for 32 bits, and attributes of all kinds.
SomeFile numbers() {
  return {NC_64BIT_DATA, [](int file) {
            const int rows = define_dimension(file, "rows", 3),
                      columns = define_dimension(file, "columns", 2);
            const int numbers = define(file, "num_a", NC_INT64, {rows, columns});
            define(file, "num_b", NC_FLOAT, {rows});
            define(file, "other", NC_CHAR, {rows, columns});
            const long long id = 7;
            const double version = 2.5;
            check(nc_put_att_longlong(file, numbers, "id", NC_INT64, 1, &id));
            check(nc_put_att_text(file, numbers, "what", 4, "six\0"));
            check(nc_put_att_double(file, NC_GLOBAL, "version", NC_DOUBLE, 1, &version));
            check(nc_put_att_text(file, NC_GLOBAL, "title", 5, " two "));
            check(nc_enddef(file));
            const std::vector<long long> values{1, 2, 3, 4, 1ll << 40, 6};
            check(nc_put_var_longlong(file, numbers, values.data()));
            check(nc_put_var_text(file, 2, "a\0 bcd"));
          }};
}

}  // namespace

TEST_CASE("what a file lacks is nothing, not an error", "[io][netcdf]") {
  const SomeFile some = numbers();
  const NetcdfFile file(some.path());
  CHECK(file.dimension("rows") == 3);
  CHECK(file.dimension("layers") == 0);
  CHECK_FALSE(file.find_variable("num_c"));
  CHECK(file.variable_names("num_") == std::vector<std::string>{"num_a", "num_b"});
  CHECK(file.n_groups() == 0);
  CHECK(file.find_global_number("version") == 2.5);
  CHECK_FALSE(file.find_global_number("title"));
  CHECK(file.find_global_text("title") == "two");
  CHECK_FALSE(file.find_global_text("version"));
  const NetcdfVariable variable = file.find_variable("num_a").value();
  CHECK(file.find_integer(variable, "id") == 7);
  CHECK_FALSE(file.find_integer(variable, "what"));
  CHECK(file.find_text(variable, "what") == "six");
  CHECK_FALSE(file.find_text(variable, "id"));
}

TEST_CASE("a variable knows its shape and type; rows are read by place", "[io][netcdf]") {
  const SomeFile some = numbers();
  const NetcdfFile file(some.path());
  const NetcdfVariable variable = file.find_variable("num_a").value();
  CHECK(variable.shape == std::vector<std::size_t>{3, 2});
  CHECK(variable.size() == 6);
  CHECK(variable.is_64_bit_integer);
  CHECK_FALSE(variable.is_chunked);
  std::vector<double> row(2);
  file.read_double(variable, {1, 1}, row);
  CHECK(row == std::vector<double>{3, 4});
  CHECK(file.rows_per_read(variable) == (1u << 18) / 2);
}

TEST_CASE("a number beyond 32 bits is said, others in its rows alone are read", "[io][netcdf]") {
  const SomeFile some = numbers();
  const NetcdfFile file(some.path());
  const NetcdfVariable variable = file.find_variable("num_a").value();
  std::vector<std::int32_t> row(2);
  CHECK(file.read_int32(variable, {0, 1}, row));
  CHECK(row == std::vector<std::int32_t>{1, 2});
  CHECK_FALSE(file.read_int32(variable, {2, 1}, row));
  std::vector<std::int64_t> all(6);
  file.read_int64(variable, all);
  CHECK(all[4] == std::int64_t{1} << 40);
}

TEST_CASE("texts are cut at their end and cleaned; numbers are no texts", "[io][netcdf]") {
  const SomeFile some = numbers();
  const NetcdfFile file(some.path());
  CHECK(file.read_texts(file.find_variable("other").value()) == std::vector<std::string>{"a", "b", "cd"});
  CHECK_THROWS_WITH(file.read_texts(file.find_variable("num_a").value()),
                    some.path() + ": variable num_a is not a list of texts");
}

TEST_CASE("a packed variable that no file of this size can hold is refused", "[io][netcdf]") {
  const SomeFile some(NC_NETCDF4, [](int file) {
    const int rows = define_dimension(file, "rows", std::size_t{1} << 40);
    const int huge = define(file, "huge", NC_DOUBLE, {rows});
    const std::size_t chunk = 1024;
    check(nc_def_var_chunking(file, huge, NC_CHUNKED, &chunk));
  });
  const NetcdfFile file(some.path());
  CHECK_THROWS_WITH(file.find_variable("huge"),
                    some.path() + ": variable huge claims more values than the file can hold");
}

TEST_CASE("a file that netCDF cannot open is called what it is", "[io][netcdf]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("b.nc");
  write_bytes(path, std::string("\x89HDF\r\n\x1a\n") + std::string(100, '\0'));
  try {
    const NetcdfFile file(path);
    FAIL("opened");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()).starts_with(path + ": damaged or truncated HDF5 file ("));
  }
}

TEST_CASE("a variable in chunks that no file of this size can hold is refused", "[io][netcdf]") {
  const SomeFile some(NC_NETCDF4, [](int file) {
    const int steps = define_dimension(file, "steps", NC_UNLIMITED);
    const int small = define(file, "small", NC_DOUBLE, {steps}),
              huge = define(file, "huge", NC_DOUBLE, {steps});
    const std::size_t one = 1, many = std::size_t{1} << 27, first = 0;
    check(nc_def_var_chunking(file, small, NC_CHUNKED, &one));
    check(nc_def_var_chunking(file, huge, NC_CHUNKED, &many));
    check(nc_enddef(file));
    const double value = 1.0;
    check(nc_put_var1_double(file, small, &first, &value));
  });
  const NetcdfFile file(some.path());
  CHECK(file.find_variable("small"));
  CHECK_THROWS_WITH(file.find_variable("huge"),
                    some.path() + ": variable huge claims more values than the file can hold");
}
