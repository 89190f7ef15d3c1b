// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/facet_moves.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

OwnershipTable table_of(const std::string& rows) {
  OwnershipTable table;
  read_surfaces_csv("t.csv", "surface,block,element,side,kind,area\n" + rows, table);
  return table;
}

}  // namespace

TEST_CASE("facets are matched by kind, element and side", "[app][compare]") {
  const OwnershipTable first = table_of("a,b,1,1,face,1\na,b,1,2,face,1\na,b,1,1,top,1\n");
  const OwnershipTable second = table_of("c,b,1,1,top,1\na,b,1,1,face,1\na,b,2,1,face,1\n");
  const auto matches = match_facets(first, second);
  REQUIRE(matches.size() == 4);
  CHECK((matches[0].first == 0 && matches[0].second == 1));
  CHECK((matches[1].first == 1 && !matches[1].second));
  CHECK((!matches[2].first && matches[2].second == 2));
  CHECK((matches[3].first == 2 && matches[3].second == 0));
}

TEST_CASE("a facet that a table lists twice is matched twice", "[app][compare]") {
  const OwnershipTable first = table_of("a,b,1,1,face,1\nc,b,1,1,face,1\n");
  CHECK(match_facets(first, first).size() == 2);
  CHECK(match_facets(first, table_of("a,b,1,1,face,1\n")).size() == 2);
}

TEST_CASE("flows count what is common, and same surfaces have all of each other", "[app][compare]") {
  const OwnershipTable first = table_of("a,b,1,1,face,1\na,b,2,1,face,1\nc,b,3,1,face,1\n");
  const OwnershipTable second = table_of("a,b,1,1,face,1\nc,b,2,1,face,1\nz,b,3,1,face,1\n");
  const auto flows = sum_flows(first, second, match_facets(first, second));
  REQUIRE(flows.size() == 3);
  CHECK((flows[1].from == 0 && flows[1].to == 1 && flows[1].n == 1 && flows[1].area == 1.0));
  const auto same = find_same_surfaces(first, second, flows);
  CHECK_FALSE(same[0]);
  CHECK(same[1] == 2);
}
