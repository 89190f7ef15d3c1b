// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "campaigns/decks/deck_harm.hpp"
#include "support/catch.hpp"

using namespace contactsim::test;

TEST_CASE("no text of the fuzzer's corpus, whole or cut short, does harm", "[parser][fuzz]") {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(CONTACTSIM_SOURCE_DIR "/tests/campaigns/decks/corpus")) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  REQUIRE(paths.size() >= 24);
  for (const auto& path : paths) {
    INFO(path);
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (std::size_t size = text.size(); size > 0; size -= std::max<std::size_t>(1, size / 16)) {
      CHECK(find_deck_harm(std::string_view(text).substr(0, size), DeckLook::all) == "");
    }
  }
}
