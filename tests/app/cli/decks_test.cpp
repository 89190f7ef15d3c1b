// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using contactsim::test::ProgramDirectory;
using contactsim::test::read_bytes;
namespace fs = std::filesystem;

namespace {

const fs::path decks = fs::path(CONTACTSIM_SOURCE_DIR) / "decks";

/// Every file *.i below decks/, as a path relative to it. What decks include is called otherwise.
std::vector<std::string> all_decks() {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(decks)) {
    if (entry.path().extension() == ".i") found.push_back(entry.path().lexically_relative(decks).string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Copies the folder of a deck, for includes are relative to the run directory.
void copy_folder_of(const std::string& deck, const ProgramDirectory& directory) {
  for (const auto& entry : fs::directory_iterator((decks / deck).parent_path())) {
    if (entry.is_regular_file())
      fs::copy_file(entry.path(), directory.path(entry.path().filename().string()));
  }
}

/// Parses a deck where it has its includes, with further arguments.
void check_parses(const std::string& deck, const std::vector<std::string>& more = {}) {
  const ProgramDirectory directory;
  copy_folder_of(deck, directory);
  std::vector<std::string> arguments{fs::path(deck).filename().string(), "--parse"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto [code, out, err] = directory.run(arguments);
  INFO(deck);
  CHECK(err == "");
  CHECK(code == 0);
}

std::size_t n_lines(const std::string& deck) {
  const std::string text = read_bytes((decks / deck).string());
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("every deck is read without an error or a warning", "[app][decks]") {
  const auto found = all_decks();
  REQUIRE(found.size() >= 3);
  for (const std::string& deck : found) check_parses(deck);
}

TEST_CASE("every deck says in its head what it shows", "[app][decks]") {
  for (const std::string& deck : all_decks()) {
    INFO(deck);
    CHECK(read_bytes((decks / deck).string()).starts_with("# "));
  }
}

TEST_CASE("two decks are of real size", "[app][decks]") {
  CHECK(n_lines("drop_test/drop_test.i") >= 300);
  CHECK(n_lines("crush_tube/crush_tube.i") >= 300);
}

TEST_CASE("the variants of the drop test are read without an error or a warning", "[app][decks]") {
  check_parses("drop_test/drop_test.i", {"-D", "way=edge", "-D", "tumble_rate=6"});
  check_parses("drop_test/drop_test.i", {"-D", "way=corner", "-D", "drop_height=1800"});
  check_parses("drop_test/drop_test.i",
               {"-D", "ground=anvil", "-D", "foam_model=orthotropic_crush", "-D", "target_step=2e-8"});
}

TEST_CASE("the variants of the crush test are read without an error or a warning", "[app][decks]") {
  check_parses("crush_tube/crush_tube.i", {"-D", "grade=2", "-D", "drive=stroke", "-D", "half=1"});
  check_parses("crush_tube/crush_tube.i", {"-D", "grade=3", "-D", "speed_kmh=40"});
}
