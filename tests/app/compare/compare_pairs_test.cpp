// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_pairs.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

OwnershipTable with_pairs(std::vector<TablePair> pairs) {
  OwnershipTable table;
  table.pairs = std::move(pairs);
  table.has_pairs = true;
  return table;
}

std::vector<Difference> differences_of(const std::vector<TablePair>& first,
                                       const std::vector<TablePair>& second, const NewNames& names = {}) {
  std::vector<Difference> differences;
  add_pairs(with_pairs(first), with_pairs(second), names, differences);
  return differences;
}

std::vector<std::string> lines_of(const std::vector<TablePair>& first, const std::vector<TablePair>& second,
                                  const NewNames& names = {}) {
  std::vector<std::string> lines;
  for (const Difference& one : differences_of(first, second, names)) lines.push_back(one.text);
  return lines;
}

using PairLines = std::vector<std::string>;

const TablePair lid_box{"lid", "box", "general contact", {{"law", "frictionless"}}};

}  // namespace

TEST_CASE("a surface has its new name where it has one", "[app][compare]") {
  CHECK(renamed("lid", {{"lid", "cap"}}) == "cap");
  CHECK(renamed("box", {{"lid", "cap"}}) == "box");
  CHECK(renamed("lid", {}) == "lid");
}

TEST_CASE("the same pairs do not differ, renamed or in another order", "[app][compare]") {
  const TablePair other{"a", "b", "tie", {}};
  CHECK(lines_of({lid_box, other}, {other, lid_box}).empty());
  CHECK(lines_of({}, {}).empty());
  CHECK(lines_of({lid_box}, {{"cap", "box", "general contact", {{"law", "frictionless"}}}},
                 {{"lid", "cap"}}) == PairLines{});
}

TEST_CASE("pairs that one table has alone are reported, by names of the second", "[app][compare]") {
  const TablePair tied{"lid", "box", "tie", {}};
  CHECK(lines_of({lid_box}, {}) == PairLines{"only in the first: pair box - lid (general contact)"});
  CHECK(lines_of({lid_box}, {tied}) == PairLines{"only in the first: pair box - lid (general contact)",
                                                 "only in the second: pair box - lid (tie)"});
  CHECK(lines_of({lid_box}, {}, {{"lid", "cap"}}) ==
        PairLines{"only in the first: pair box - cap (general contact)"});
  CHECK(differences_of({}, {lid_box}).at(0).kind == "pair_only_in_second");
}

TEST_CASE("each setting that differs is reported, also one that a table lacks", "[app][compare]") {
  const TablePair first{"a", "b", "i", {{"law", "tied"}, {"scale", "1.0"}, {"same", "x"}}};
  const TablePair second{"a", "b", "i", {{"law", "glued"}, {"same", "x"}, {"tolerance", "0.1"}}};
  const std::vector<Difference> found = differences_of({first}, {second});
  REQUIRE(found.size() == 3);
  CHECK(found[0].text == "pair a - b (i): law tied -> glued");
  CHECK(found[1].text == "pair a - b (i): scale 1.0 -> absent");
  CHECK(found[2].text == "pair a - b (i): tolerance absent -> 0.1");
  CHECK(found[0].kind == "pair");
  using Fields = std::vector<std::pair<std::string, Difference::Value>>;
  CHECK(found[0].fields == Fields{{"pair", std::string("a - b (i)")},
                                  {"setting", std::string("law")},
                                  {"first", std::string("tied")},
                                  {"second", std::string("glued")}});
}

TEST_CASE("sides that change places are counted, settings are compared all the same", "[app][compare]") {
  const TablePair turned{"box", "lid", "general contact", {{"law", "tied"}}}, ab{"a", "b", "", {}},
      ba{"b", "a", "", {}};
  CHECK(lines_of({lid_box}, {turned}) ==
        PairLines{"pair box - lid (general contact): law frictionless -> tied",
                  "first and second change places in 1 pair"});
  CHECK(lines_of({lid_box, ab}, {{"box", "lid", "general contact", {{"law", "frictionless"}}}, ba}) ==
        PairLines{"first and second change places in 2 pairs"});
  CHECK(lines_of({{"a", "a", "self contact", {}}}, {{"a", "a", "self contact", {}}}).empty());
}
