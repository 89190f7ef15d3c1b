// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/record_file.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <numeric>

#include "io/netcdf/netcdf_file.hpp"
#include "io/netcdf/netcdf_output.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr std::size_t n_values = 40000;  // more than go to the file at a time

/// A file with a fixed variable and the record variables a, one number, and b, many of them.
void make_file(const std::string& path, bool large) {
  NetcdfOutput output(path, large);
  const int records = output.define_dimension("record", NetcdfOutput::unlimited);
  const int rows = output.define_dimension("rows", n_values);
  const int fixed = output.define_variable("fixed", NetcdfType::float64, {rows});
  output.define_variable("a", NetcdfType::float64, {records});
  output.define_variable("b", NetcdfType::float64, {records, rows});
  output.end_definitions();
  output.write(fixed, std::vector<double>(n_values, 7.0));
  output.commit();
}

/// What record `number` holds: a counts on, b too.
void write_record(RecordFile& file, double number) {
  std::vector<double> pairs(2 * n_values);
  std::iota(pairs.begin(), pairs.end(), number);
  file.write("a", std::span(&number, 1));
  file.write("b", pairs, {1, 2});
  file.end_record();
}

void check_records(const std::string& path, std::size_t n_records) {
  const NetcdfFile file(path);
  const NetcdfVariable a = *file.find_variable("a"), b = *file.find_variable("b");
  REQUIRE(a.shape == std::vector<std::size_t>{n_records});
  std::vector<double> values(n_values);
  for (std::size_t r = 0; r < n_records; ++r) {
    double number = -1.0;
    file.read_double(a, {r, 1}, std::span(&number, 1));
    CHECK(number == static_cast<double>(r));
    file.read_double(b, {r, 1}, values);
    std::size_t n_wrong = 0;
    for (std::size_t i = 0; i < n_values; ++i) n_wrong += values[i] != number + 1.0 + 2.0 * double(i);
    CHECK(n_wrong == 0);
  }
  file.read_double(*file.find_variable("fixed"), values);
  CHECK(values == std::vector<double>(n_values, 7.0));
}

/// Writes a second record in a process that is killed by the write that passes a size of the file.
void write_until_killed_at(const std::string& path, std::uintmax_t n_bytes) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    // Catch's handlers would speak for the child.
    std::signal(SIGXFSZ, SIG_DFL);
    const rlimit no_core{0, 0}, size{n_bytes, n_bytes};
    setrlimit(RLIMIT_CORE, &no_core);
    setrlimit(RLIMIT_FSIZE, &size);
    RecordFile file(path);
    write_record(file, 1.0);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
}

}  // namespace

TEST_CASE("records are where netCDF looks for them", "[io][records]") {
  const bool large = GENERATE(false, true);
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.nc");
  make_file(path, large);
  check_records(path, 0);
  {
    RecordFile file(path);
    for (std::size_t r = 0; r < 3; ++r) {
      write_record(file, static_cast<double>(r));
      CHECK(file.n_records() == r + 1);
      check_records(path, r + 1);
    }
  }
  RecordFile again(path);
  write_record(again, 3.0);
  check_records(path, 4);
}

TEST_CASE("a record that is not ended does not count", "[io][records]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.nc");
  make_file(path, false);
  RecordFile file(path);
  write_record(file, 0.0);
  const double number = 1.0;
  file.write("a", std::span(&number, 1));
  check_records(path, 1);
}

TEST_CASE("a process that is killed in the middle of a record leaves those before", "[io][records]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.nc");
  make_file(path, false);
  {
    RecordFile file(path);
    write_record(file, 0.0);
  }
  const std::uintmax_t end = std::filesystem::file_size(path), record = (n_values + 1) * sizeof(double);
  for (const std::uintmax_t place : {std::uintmax_t{0}, std::uintmax_t{8}, record / 2, record - 1}) {
    write_until_killed_at(path, end + place);
    check_records(path, 1);
  }
}

TEST_CASE("a file that is not there cannot be written", "[io][records]") {
  const TemporaryDirectory directory;
  CHECK_THROWS(RecordFile(directory.file("r.nc")));
}
