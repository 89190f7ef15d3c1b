// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/text_file.hpp"

#include <sys/stat.h>

#include <filesystem>

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Failure = TextFile::Failure;

TextFile read_of_bytes(const std::string& bytes) {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a.i"), bytes);
  return read_text_file(directory.file("a.i"));
}

void check_refused(const TextFile& file, const std::string& problem, Failure failure) {
  CHECK(file.problem == problem);
  CHECK(file.failure == failure);
  CHECK(file.text == "");
}

}  // namespace

TEST_CASE("a text is read to the byte, an empty one too", "[parser][files]") {
  for (const std::string text : {"", "begin\n", "no end of line", "\r\n\t\x01",
                                 "\xef\xbb\xbfgr\xc3\xbc\xc3\x9f", "CD", "\xff text in Latin-1 \xe4"}) {
    const TextFile file = read_of_bytes(text);
    CHECK(file.text == text);
    CHECK(file.problem == "");
    CHECK(file.failure == Failure::none);
  }
}

TEST_CASE("what is no text is called what it is", "[parser][files]") {
  check_refused(read_of_bytes("\xff\xfe"
                              "b"),
                "it is a UTF-16 text, save it as UTF-8", Failure::not_text);
  check_refused(read_of_bytes("\xfe\xff"
                              "b"),
                "it is a UTF-16 text, save it as UTF-8", Failure::not_text);
  check_refused(read_of_bytes("CDF\x01"), "it is a mesh (NetCDF) file, not a text", Failure::not_text);
  check_refused(read_of_bytes("\x89HDF\r\n"), "it is a mesh (NetCDF) file, not a text", Failure::not_text);
  check_refused(read_of_bytes(std::string("ab\0c", 4)), "it is a binary file, not a text", Failure::not_text);
}

TEST_CASE("what is not there, a folder or a pipe is refused without being read", "[parser][files]") {
  const TemporaryDirectory directory;
  check_refused(read_text_file(directory.file("none")), "there is no such file", Failure::missing);
  check_refused(read_text_file(directory.file("no/none")), "there is no such file", Failure::missing);
  check_refused(read_text_file(""), "there is no such file", Failure::missing);
  check_refused(read_text_file(directory.file("")), "it is a directory", Failure::unreadable);
  REQUIRE(mkfifo(directory.file("pipe").c_str(), 0600) == 0);
  check_refused(read_text_file(directory.file("pipe")), "it is not a regular file", Failure::unreadable);
  check_refused(read_text_file("/dev/zero"), "it is not a regular file", Failure::unreadable);
  std::filesystem::create_symlink(directory.file("gone"), directory.file("link"));
  check_refused(read_text_file(directory.file("link")), "there is no such file", Failure::missing);
}

TEST_CASE("a file of more than 64 MiB is refused by its size alone", "[parser][files]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("large"), "");
  std::filesystem::resize_file(directory.file("large"), (std::uintmax_t{64} << 20) + 1);  // a hole
  check_refused(read_text_file(directory.file("large")), "it is larger than 64 MiB, too large for a deck",
                Failure::unreadable);
}

TEST_CASE("where no file is to be read, none is", "[parser][files]") {
  check_refused(read_no_file("a.i"), "files are not read here", Failure::unreadable);
}
