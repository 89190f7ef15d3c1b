// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/id_lookup.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Ids = std::vector<std::int64_t>;

constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

}  // namespace

TEST_CASE("an id is found where it first stands, whatever the order of the ids", "[core][id_lookup]") {
  const Ids ids = GENERATE(Ids{}, Ids{5}, Ids{1, 2, 3}, Ids{-7, 10, 1'000'000'000'000},   // increasing
                           Ids{3, 1, 2}, Ids{4, 4}, Ids{9, 7, 9, 7, 8}, Ids{-1, -3, 60},  // in a narrow range
                           Ids{1'000'000'000'000, -7, 10}, Ids{5, 900, 5, 1, 900},        // in a wide one
                           Ids{most, least, 0, most});
  const IdLookup lookup(ids);
  for (const std::int64_t id :
       Ids{least, -7, -3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 60, 61, 900, 1'000'000'000'000, most}) {
    const auto expected = std::find(ids.begin(), ids.end(), id);
    const auto found = lookup.find(ids, id);
    CAPTURE(ids, id);
    REQUIRE(found.has_value() == (expected != ids.end()));
    if (found) CHECK(*found == expected - ids.begin());
  }
}

TEST_CASE("the first id that stood before is known", "[core][id_lookup]") {
  CHECK_FALSE(IdLookup(Ids{}).first_repeat());
  CHECK_FALSE(IdLookup(Ids{1, 2, 3}).first_repeat());
  CHECK_FALSE(IdLookup(Ids{3, 1, 2}).first_repeat());
  CHECK_FALSE(IdLookup(Ids{1'000'000, 1, 2}).first_repeat());
  CHECK(IdLookup(Ids{4, 4}).first_repeat() == 1u);
  CHECK(IdLookup(Ids{9, 7, 8, 7, 9}).first_repeat() == 3u);                  // in a narrow range
  CHECK(IdLookup(Ids{1'000'000, 7, 8, 7, 1'000'000}).first_repeat() == 3u);  // in a wide one
}
