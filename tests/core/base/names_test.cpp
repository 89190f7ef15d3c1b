// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/names.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("names fold case and blanks", "[core][names]") {
  CHECK(fold("My Block") == "my_block");
  CHECK(fold("SURFACE_7") == "surface_7");
}

TEST_CASE("names of a deck are the same whatever their case, with blanks as underscores", "[core][names]") {
  CHECK(DeckName{"My Block", {}} == DeckName{"my_BLOCK", {}});
  CHECK_FALSE(DeckName{"block", {}} == DeckName{"block_1", {}});
  CHECK_FALSE(DeckName{"block_2", {}} == DeckName{"block_1", {}});
}

TEST_CASE("edit distance counts single typing mistakes", "[core][names]") {
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("block", "block") == 0);
  CHECK(edit_distance("blcok", "block") == 1);  // neighbours swapped
  CHECK(edit_distance("blck", "block") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("the nearest name is offered only when it is near", "[core][names]") {
  const std::vector<std::string> names{"steel", "Aluminum", "foam"};
  CHECK(find_nearest("stel", names) == "steel");
  CHECK(find_nearest("ALUMINIUM", names) == "Aluminum");
  CHECK(find_nearest("copper", names) == std::nullopt);
  CHECK(suggest("foma", names) == "did you mean 'foam'?");
  CHECK(suggest("xyz", names).empty());
  // Neither offered nor compared letter by letter, which would take hours.
  const std::string endless(10'000'000, 'a');
  CHECK(find_nearest(endless, std::vector<std::string>{endless + "b"}) == std::nullopt);
}
