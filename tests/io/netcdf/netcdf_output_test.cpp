// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/netcdf_output.hpp"

#include <filesystem>

#include "core/base/errors.hpp"
#include "io/netcdf/netcdf_file.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::size_t count_files(const TemporaryDirectory& directory) {
  const std::filesystem::directory_iterator files(directory.file("")), end;
  return static_cast<std::size_t>(std::distance(files, end));
}

}  // namespace

TEST_CASE("what is written can be read", "[io][output]") {
  const bool large = GENERATE(false, true);
  const TemporaryDirectory directory;
  NetcdfOutput output(directory.file("a.nc"), large);
  const int rows = output.define_dimension("rows", 2), columns = output.define_dimension("columns", 3);
  const int numbers = output.define_variable("numbers", NetcdfType::int32, {rows, columns});
  const int reals = output.define_variable("reals", NetcdfType::float64, {rows});
  const int texts = output.define_variable("texts", NetcdfType::text, {rows, columns});
  output.set_text(numbers, "what", "six");
  output.set_number(NetcdfOutput::global, "version", NetcdfType::float32, 2.5);
  output.end_definitions();
  output.write(numbers, std::vector<std::int32_t>{1, 2, 3, 4, 5, 6});
  output.write(reals, std::vector<double>{0.5, 0.25});
  output.write(texts, 3, {"a", "longer"});
  output.commit();

  const NetcdfFile file(directory.file("a.nc"));
  std::vector<std::int64_t> found(6);
  file.read_int64(*file.find_variable("numbers"), found);
  CHECK(found == std::vector<std::int64_t>{1, 2, 3, 4, 5, 6});
  CHECK(file.read_texts(*file.find_variable("texts")) == std::vector<std::string>{"a", "lon"});
  CHECK(file.find_text(*file.find_variable("numbers"), "what") == "six");
  CHECK(file.find_global_number("version") == 2.5);
  CHECK(count_files(directory) == 1);
}

TEST_CASE("a file that is not committed leaves the old one and nothing else", "[io][output]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a.nc"), "old");
  {
    NetcdfOutput output(directory.file("a.nc"), false);
    output.define_dimension("rows", 2);
  }
  CHECK(read_bytes(directory.file("a.nc")) == "old");
  CHECK(count_files(directory) == 1);
}

TEST_CASE("a place that cannot be written to is named", "[io][output]") {
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(NetcdfOutput(directory.file("no/a.nc"), false),
                    directory.file("no/a.nc") + ": cannot be created (No such file or directory)");
  std::filesystem::create_directory(directory.file("taken"));
  NetcdfOutput output(directory.file("taken"), false);
  output.end_definitions();
  CHECK_THROWS_WITH(output.commit(), directory.file("taken") + ": cannot be written (Is a directory)");
  CHECK(count_files(directory) == 1);
}
