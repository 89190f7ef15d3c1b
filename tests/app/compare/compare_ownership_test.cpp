// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_ownership.hpp"

#include <string>

#include "support/catch.hpp"

using namespace contactsim;

namespace compare_ownership_test {

namespace {

constexpr const char* header = "surface,block,element,side,kind,area\n";

OwnershipTable table_of(const std::string& rows) {
  OwnershipTable table;
  read_surfaces_csv("t.csv", header + rows, table);
  return table;
}

std::vector<std::string> texts(const std::string& first, const std::string& second,
                               bool lists_faces = false) {
  std::vector<std::string> lines;
  for (const Difference& one : compare_ownership(table_of(first), table_of(second), {}, lists_faces))
    lines.push_back(one.text);
  return lines;
}

/// Four faces of a block, of which the owner of each is given.
std::string rows(std::vector<std::string> owners) {
  std::string text;
  for (std::size_t i = 0; i < owners.size(); ++i)
    text += owners[i] + ",b," + std::to_string(i + 1) + ",6,face,0.5\n";
  return text;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("tables that hold the same do not differ, whatever their order of rows", "[app][compare]") {
  CHECK(texts(rows({"a", "a", "c"}), rows({"a", "a", "c"})).empty());
  CHECK(texts("a,b,1,1,face,2\na,b,2,1,face,2\n", "a,b,2,1,face,2\na,b,1,1,face,2\n").empty());
}

TEST_CASE("what moves is one line for each two surfaces", "[app][compare]") {
  CHECK(texts(rows({"a", "a", "a", "c"}), rows({"a", "c", "c", "c"})) ==
        Lines{"moved: 2 facets from 'a' to 'c', area 1"});
}

TEST_CASE("each facet that moves is listed when that is asked for", "[app][compare]") {
  CHECK(texts(rows({"a", "a", "c"}), rows({"a", "c", "c"}), true) ==
        Lines{"moved: 1 facet from 'a' to 'c', area 0.5",
              "face: block 'b' element 2 side 6 (face): 'a' -> 'c'"});
}

TEST_CASE("a renamed surface is one line and none of its facets moves", "[app][compare]") {
  CHECK(texts(rows({"a", "a", "c"}), rows({"z", "z", "c"}), true) ==
        Lines{"renamed: 'a' is 'z' in the second"});
}

TEST_CASE("two surfaces that exchange their facets are one line", "[app][compare]") {
  CHECK(texts(rows({"a", "a", "c"}), rows({"c", "c", "a"})) == Lines{"swapped: 'a' and 'c'"});
}

TEST_CASE("another order of the same surfaces is one line", "[app][compare]") {
  CHECK(texts("a,b,1,1,face,2\nc,b,2,1,face,2\n", "c,b,2,1,face,2\na,b,1,1,face,2\n") ==
        Lines{"order: a, c -> c, a"});
}

TEST_CASE("a surface that loses all to another that grows has moved, and is in the first alone",
          "[app][compare]") {
  CHECK(texts(rows({"a", "c"}), rows({"c", "c"})) ==
        Lines{"only in the first: surface 'a'", "moved: 1 facet from 'a' to 'c', area 0.5"});
}

TEST_CASE("facets of one table alone are counted by surface", "[app][compare]") {
  CHECK(texts(rows({"a", "a"}), rows({"a", "a", "a", "a"})) == Lines{"only in the second: 2 facets of 'a'"});
}

TEST_CASE("an area beyond the tolerance is reported with the first facet", "[app][compare]") {
  CHECK(texts("a,b,7,3,face,2\n", "a,b,7,3,face,2.0000001\n").empty());
  CHECK(texts("a,b,7,3,face,2\n", "a,b,7,3,face,2.1\n") ==
        Lines{"area: 1 facet of 'a', first element 7 side 3: 2 -> 2.1"});
}

TEST_CASE("a face and a node of the same id are two things", "[app][compare]") {
  CHECK(texts("a,b,7,0,face,2\nn,,7,0,node,0\n", "a,b,7,0,face,2\nn,,7,0,node,0\n").empty());
  CHECK(texts("a,b,7,0,face,2\nn,,7,0,node,0\n", "a,b,7,0,face,2\n").size() == 2);
}

TEST_CASE("names with commas, quotes and blanks are compared as they are", "[app][compare]") {
  CHECK(texts("\"a, \"\"x\"\"\",b,1,1,face,1\nc d,b,2,1,face,1\n", "c d,b,1,1,face,1\nc d,b,2,1,face,1\n") ==
        Lines{"only in the first: surface 'a, \"x\"'", "moved: 1 facet from 'a, \"x\"' to 'c d', area 1"});
}

}  // namespace compare_ownership_test
