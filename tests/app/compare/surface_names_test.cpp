// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/surface_names.hpp"

#include "app/compare/compare_ownership.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

using Lines = std::vector<std::string>;

/// A table without facets: surfaces, each with how much it owns.
OwnershipTable table_of(const std::vector<std::pair<std::string, double>>& surfaces) {
  OwnershipTable table;
  table.has_figures = true;
  for (const auto& [name, owned] : surfaces) table.surfaces.push_back({name, "face", {{"owned", owned}}, {}});
  return table;
}

Lines texts(const OwnershipTable& first, const OwnershipTable& second) {
  Lines lines;
  for (const Difference& one : compare_ownership(first, second, {}, false)) lines.push_back(one.text);
  return lines;
}

}  // namespace

TEST_CASE("without facets surfaces of the same figures were renamed or swapped", "[app][compare]") {
  CHECK(texts(table_of({{"a", 5}, {"c", 7}}), table_of({{"z", 5}, {"c", 7}})) ==
        Lines{"renamed: 'a' is 'z' in the second"});
  CHECK(texts(table_of({{"a", 5}, {"c", 7}}), table_of({{"a", 7}, {"c", 5}})) ==
        Lines{"swapped: 'a' and 'c'"});
}

TEST_CASE("surfaces whose figures another has too are not taken for each other", "[app][compare]") {
  const auto same = find_same_figures(table_of({{"a", 5}, {"c", 5}}), table_of({{"y", 5}, {"z", 6}}));
  CHECK_FALSE(same[0]);
  CHECK_FALSE(same[1]);
}

TEST_CASE("claims that a winner keeps no more have moved", "[app][compare]") {
  OwnershipTable first = table_of({{"top", 4}, {"left", 6}}), second = table_of({{"top", 1}, {"left", 9}});
  first.surfaces[1].lost_to = {{"top", 3}};
  CHECK(texts(first, second) == Lines{"moved: 3 facets from 'top' to 'left'", "changed: 'top' owned 4 -> 1",
                                      "changed: 'left' owned 6 -> 9"});
}
