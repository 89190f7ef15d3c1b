// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/deck_source.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

/// A folder that is gone after the test.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::path(CONTACTSIM_BINARY_DIR) / "tests" / name) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (path_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("a deck file is read and expanded with the given variables", "[parser][deck_source]") {
  const Folder folder("deck_source_reads");
  const std::string included = folder.write("part.i", "part {n}\n");
  const std::string deck = folder.write("deck.i", "a {n + 1}\n{include(\"" + included + "\")}\n");
  const std::vector<std::string> overrides = {"n=4"};
  Diagnostics diagnostics;
  const Source source = read_deck_source(deck, {overrides}, diagnostics);
  CHECK(messages(diagnostics) == "");
  CHECK(source.text() == "a 5\npart 4\n");
  CHECK(to_string(source.locate(4)) == included + ":1:1");
}

TEST_CASE("an empty deck is empty", "[parser][deck_source]") {
  const Folder folder("deck_source_empty");
  Diagnostics diagnostics;
  CHECK(read_deck_source(folder.write("deck.i", ""), {}, diagnostics).text().empty());
  CHECK(diagnostics.empty());
}

TEST_CASE("a deck that cannot be opened is a file error", "[parser][deck_source]") {
  const Folder folder("deck_source_missing");
  Diagnostics diagnostics;
  CHECK_THROWS_WITH(read_deck_source(folder.path() + "/none.i", {}, diagnostics),
                    folder.path() + "/none.i: there is no such file");
  CHECK_THROWS_WITH(read_deck_source(folder.path(), {}, diagnostics), folder.path() + ": it is a directory");
  CHECK_THROWS_WITH(read_deck_source("/dev/zero", {}, diagnostics), "/dev/zero: it is not a regular file");
  CHECK_THROWS_AS(read_deck_source("", {}, diagnostics), FileError);
}

TEST_CASE("a file that is no text is called what it is", "[parser][deck_source]") {
  const Folder folder("deck_source_binary");
  const auto refused = [&](const std::string& content) {
    Diagnostics diagnostics;
    const std::string path = folder.write("deck.i", content);
    CHECK_THROWS_AS(read_deck_source(path, {}, diagnostics), DeckError);
    const std::string text = messages(diagnostics);
    return text.substr(text.find(" is no deck: ") + 13);
  };
  CHECK(refused(std::string("CDF\1\0", 5)) == "it is a mesh (NetCDF) file, not a text\n");
  CHECK(refused("\x89HDF\r\n") == "it is a mesh (NetCDF) file, not a text\n");
  CHECK(refused(std::string("\xFF\xFE"
                            "b\0",
                            4)) == "it is a UTF-16 text, save it as UTF-8\n");
  CHECK(refused(std::string("begin\0", 6)) == "it is a binary file, not a text\n");
}
