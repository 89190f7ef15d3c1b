// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/read_layout.hpp"

#include <netcdf.h>

#include "io/netcdf/netcdf_output.hpp"
#include "support/catch.hpp"
#include "support/netcdf_check.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using contactsim::test::check;
using contactsim::test::TemporaryDirectory;

TEST_CASE("a layout that is written is read again", "[io][layout]") {
  const bool large = GENERATE(false, true);
  const NetcdfLayout layout{
      {{"time_step", 2, true}, {"n", 3, false}},
      {{"text", NetcdfType::text, {"n"}, {{"elem_type", NetcdfType::text, std::vector<char>{'H', 'E', 'X'}}}},
       {"reals", NetcdfType::float32, {"time_step", "n"}, {}},
       {"number", NetcdfType::int32, {}, {{"pair", NetcdfType::int32, std::vector<std::int64_t>{1, -2}}}}},
      {{"version", NetcdfType::float32, std::vector<double>{2.5}}}};
  const TemporaryDirectory directory;
  NetcdfOutput output(directory.file("a.nc"), large);
  output.define(layout);
  output.end_definitions();
  output.write(0, std::nullopt, std::vector<char>{'a', 'b', 'c'});
  output.write(2, std::nullopt, std::vector<std::int64_t>{-7});
  for (const std::size_t record : {0u, 1u}) output.write(1, record, std::vector<double>{1.5, 2.5, 3.5});
  output.commit();

  const NetcdfFile file(directory.file("a.nc"));
  const NetcdfLayout found = read_layout(file);
  REQUIRE(found.dimensions.size() == 2);
  CHECK(found.dimensions[0].is_unlimited);
  CHECK(found.length("time_step") == 2);
  REQUIRE(found.variables.size() == 3);
  for (std::size_t v = 0; v < 3; ++v) {
    CHECK(found.variables[v].name == layout.variables[v].name);
    CHECK(found.variables[v].type == layout.variables[v].type);
    CHECK(found.variables[v].dimensions == layout.variables[v].dimensions);
  }
  CHECK(found.variables[0].attributes[0].values == layout.variables[0].attributes[0].values);
  CHECK(found.variables[2].attributes[0].values == layout.variables[2].attributes[0].values);
  CHECK(found.attributes[0].values == layout.attributes[0].values);
  std::vector<std::int64_t> number(1);
  file.read_int64(file.find_variable("number").value(), number);
  CHECK(number[0] == -7);
  std::vector<char> text(2);
  file.read_text(file.find_variable("text").value(), {1, 2}, text);
  CHECK(text == std::vector<char>{'b', 'c'});
}

TEST_CASE("texts of netCDF-4 are attributes but no variables", "[io][layout]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.nc");
  int id = 0, dimension = 0, variable = 0;
  check(nc_create(path.c_str(), NC_NETCDF4, &id));
  check(nc_def_dim(id, "n", 2, &dimension));
  const char* title = "a title";
  check(nc_put_att_string(id, NC_GLOBAL, "title", 1, &title));
  check(nc_def_var(id, "small", NC_BYTE, 1, &dimension, &variable));
  check(nc_close(id));
  CHECK(whole_text(find_attribute(read_layout(NetcdfFile(path)).attributes, "title")) == "a title");
  CHECK(read_layout(NetcdfFile(path)).variables[0].type == NetcdfType::int32);
  check(nc_open(path.c_str(), NC_WRITE, &id));
  check(nc_def_var(id, "texts", NC_STRING, 1, &dimension, &variable));
  check(nc_close(id));
  CHECK_THROWS_WITH(read_layout(NetcdfFile(path)),
                    Catch::Matchers::Contains("variable texts holds neither texts nor numbers"));
}
