// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/output_place.hpp"

#include <sys/stat.h>

#include <filesystem>
#include <thread>

#include "core/base/errors.hpp"
#include "io/files/write_text.hpp"
#include "io/netcdf/netcdf_output.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
namespace fs = std::filesystem;

TEST_CASE("a file gets its name when it is complete", "[io][output]") {
  const TemporaryDirectory directory;
  const OutputPlace place(directory.file("table.csv"));
  write_bytes(place.unfinished(), "rows");
  CHECK_FALSE(fs::exists(directory.file("table.csv")));
  CHECK(place.commit() == "");
  CHECK(read_bytes(directory.file("table.csv")) == "rows");
  CHECK_FALSE(fs::exists(place.unfinished()));
}

TEST_CASE("what a link points to is written, and the link stays", "[io][output]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("real.csv"), "old");
  fs::create_symlink(directory.file("real.csv"), directory.file("link.csv"));
  write_text(directory.file("link.csv"), "new");
  CHECK(fs::is_symlink(directory.file("link.csv")));
  CHECK(read_bytes(directory.file("real.csv")) == "new");
}

TEST_CASE("a pipe is written to as it is, and never replaced", "[io][output]") {
  const TemporaryDirectory directory;
  const std::string pipe = directory.file("pipe");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  std::string received;
  std::thread reader([&] { received = read_bytes(pipe); });
  write_text(pipe, "rows");
  reader.join();
  CHECK(received == "rows");
  CHECK(fs::is_fifo(pipe));
}

TEST_CASE("a netCDF file cannot go into a pipe", "[io][output]") {
  const TemporaryDirectory directory;
  const std::string pipe = directory.file("pipe");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_AS(NetcdfOutput(pipe, false), FileError);
  CHECK(fs::is_fifo(pipe));
}

TEST_CASE("a file in place of which a directory stands says so", "[io][output]") {
  const TemporaryDirectory directory;
  fs::create_directory(directory.file("taken"));
  CHECK_THROWS_AS(write_text(directory.file("taken"), "rows"), FileError);
  CHECK(fs::is_empty(directory.file("taken")));
  CHECK_FALSE(fs::exists(directory.file("taken.part")));
}
