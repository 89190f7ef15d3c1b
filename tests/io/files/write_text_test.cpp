// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/write_text.hpp"

#include <filesystem>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a text replaces the file as a whole", "[io][files]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a.csv"), "an older and longer text");
  write_text(directory.file("a.csv"), std::string_view("one\r\n\0two", 9));
  CHECK(read_bytes(directory.file("a.csv")) == std::string("one\r\n\0two", 9));
  const std::filesystem::directory_iterator files(directory.file("")), end;
  CHECK(std::distance(files, end) == 1);
}

TEST_CASE("a text that cannot be written is an error and leaves nothing", "[io][files]") {
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(write_text(directory.file("no/a.csv"), "a"),
                    directory.file("no/a.csv") + ": the file cannot be written");
  CHECK_THROWS_AS(write_text("/dev/full", "a"), FileError);
  std::filesystem::create_directory(directory.file("taken"));
  CHECK_THROWS_AS(write_text(directory.file("taken"), "a"), FileError);
  CHECK_FALSE(std::filesystem::exists(directory.file("taken.part")));
}
