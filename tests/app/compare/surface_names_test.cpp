// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/surface_names.hpp"

#include <algorithm>

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

namespace {

std::vector<std::pair<std::string, double>> forty_surfaces() {
  std::vector<std::pair<std::string, double>> surfaces;
  for (int i = 0; i < 40; ++i) surfaces.emplace_back("s" + std::to_string(i + 1), 100.0 + i);
  return surfaces;
}

/// General contact of all with all, in the order of the table.
OwnershipTable with_pairs(OwnershipTable table) {
  table.has_pairs = true;
  for (std::size_t i = 0; i < table.surfaces.size(); ++i) {
    for (std::size_t j = i + 1; j < table.surfaces.size(); ++j)
      table.pairs.push_back(
          {table.surfaces[i].name, table.surfaces[j].name, "general contact", {{"law", "frictionless"}}});
  }
  return table;
}

}  // namespace

TEST_CASE("names that went round are one line", "[app][compare]") {
  CHECK(texts(table_of({{"a", 5}, {"b", 6}, {"c", 7}}), table_of({{"b", 5}, {"c", 6}, {"a", 7}})) ==
        Lines{"permuted: 'a' is 'b' is 'c' is 'a' in the second"});
  auto turned = forty_surfaces();
  for (std::size_t i = 0; i < 40; ++i) turned[i].second = 100.0 + static_cast<double>((i + 1) % 40);
  CHECK(texts(with_pairs(table_of(forty_surfaces())), with_pairs(table_of(turned))).size() == 2);
}

TEST_CASE("another order of forty surfaces with all their pairs is two lines", "[app][compare]") {
  const OwnershipTable first = with_pairs(table_of(forty_surfaces()));
  auto surfaces = forty_surfaces();
  std::swap(surfaces[2], surfaces[16]);
  // 13 between and the two themselves: each of the 13 with both, and the two.
  CHECK(texts(first, with_pairs(table_of(surfaces))) ==
        Lines{"order: 's3' and 's17', 3 and 17 of 40, change places",
              "first and second change places in 27 pairs"});
  surfaces = forty_surfaces();
  std::ranges::rotate(surfaces, surfaces.begin() + 1);
  CHECK(texts(first, with_pairs(table_of(surfaces))) ==
        Lines{"order: 's1' goes from place 1 to 40 of 40", "first and second change places in 39 pairs"});
}

TEST_CASE("a renamed surface has the pairs that it had", "[app][compare]") {
  OwnershipTable first = with_pairs(table_of({{"a", 5}, {"b", 6}, {"c", 7}}));
  OwnershipTable second = with_pairs(table_of({{"z", 5}, {"b", 6}, {"c", 7}}));
  second.pairs[0].settings = {{"law", "friction 0.3"}};
  CHECK(texts(first, second) == Lines{"renamed: 'a' is 'z' in the second",
                                      "pair b - z (general contact): law frictionless -> friction 0.3"});
}
