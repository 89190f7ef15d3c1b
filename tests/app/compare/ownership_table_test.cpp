// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/ownership_table.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

constexpr const char* facet_header = "surface,block,element,side,kind,area\n";

OwnershipTable facets_of(const std::string& rows) {
  OwnershipTable made;
  read_surfaces_csv("t.csv", facet_header + rows, made);
  return made;
}

OwnershipTable table_of_json(const std::string& text) {
  OwnershipTable made;
  read_surfaces_json("t.json", text, made);
  return made;
}

std::vector<std::string> surface_names(const OwnershipTable& of) {
  std::vector<std::string> names;
  for (const TableSurface& surface : of.surfaces) names.push_back(surface.name);
  return names;
}

}  // namespace

TEST_CASE("surfaces of a table in JSON have their figures and losses, lines do not count", "[app][compare]") {
  const OwnershipTable made = table_of_json(R"({"surfaces": [
    {"name": "lid", "kind": "face", "line": 7, "claimed": 9, "owned": 5, "lofted": {"top": 2, "bottom": 1.5},
     "lost_to": [{"surface": "box", "faces": 3, "lofted": 1}, {"surface": "dust", "nodes": 4}]},
    {"name": "dust", "lost_to": []}]})");
  REQUIRE(made.surfaces.size() == 2);
  CHECK(made.surfaces[0].kind == "face");
  using Figures = std::vector<std::pair<std::string, double>>;
  CHECK(made.surfaces[0].figures ==
        Figures{{"claimed", 9.0}, {"owned", 5.0}, {"lofted top", 2.0}, {"lofted bottom", 1.5}});
  using LostTo = std::vector<std::pair<std::string, std::int64_t>>;
  CHECK(made.surfaces[0].lost_to == LostTo{{"box", 4}, {"dust", 4}});
  CHECK(made.surfaces[1].name == "dust");
  CHECK(made.surfaces[1].kind == "");
  CHECK(made.has_figures);
  CHECK_FALSE(made.has_facets);
  CHECK_FALSE(made.has_pairs);
}

TEST_CASE("pairs of a table in JSON have their settings as texts", "[app][compare]") {
  const OwnershipTable made = table_of_json(R"({"surfaces": [], "pairs": [
    {"first": "a", "second": "b", "interaction": "tie", "line": 3, "law": "tied", "scale": 1.5, "reach": null,
     "sided": true}, {"first": "c", "second": "c"}]})");
  CHECK(made.has_pairs);
  REQUIRE(made.pairs.size() == 2);
  CHECK(made.pairs[0].interaction == "tie");
  using Settings = std::vector<std::pair<std::string, std::string>>;
  CHECK(made.pairs[0].settings ==
        Settings{{"law", "tied"}, {"scale", "1.5"}, {"reach", "null"}, {"sided", "true"}});
  CHECK(made.pairs[1].interaction == "");
  CHECK(made.pairs[1].settings.empty());
}

TEST_CASE("a table in JSON that is not as it should be is refused", "[app][compare]") {
  for (const char* text :
       {"", "{", "[]", "{}", R"({"surfaces": [{}]})", R"({"surfaces": [{"name": "a"}]})",
        R"({"surfaces": [{"name": 1, "lost_to": []}]})", R"({"surfaces": [{"name": "a", "lost_to": [{}]}]})",
        R"({"surfaces": [{"name": "a", "x": {"y": "z"}, "lost_to": []}]})",
        R"({"surfaces": [], "pairs": [{}]})", R"({"surfaces": [], "pairs": [{"first": "a", "second": 2}]})",
        R"({"surfaces": 3})"}) {
    INFO(text);
    CHECK_THROWS_WITH(table_of_json(text),
                      Contains("t.json: no ownership table as --surfaces-json writes it ("));
    CHECK_THROWS_AS(table_of_json(text), FileError);
  }
}

TEST_CASE("facets name surfaces, kinds and blocks, each once and as they come", "[app][compare]") {
  const OwnershipTable made = facets_of(
      "lid,low,11,6,face,0.25\n\"a, b\",low,12,1,face,1e-3\nlid,,900,0,node,0\nlid,high,13,2,lofted_top,2\n");
  CHECK(surface_names(made) == std::vector<std::string>{"lid", "a, b"});
  CHECK(made.kinds == std::vector<std::string>{"face", "node", "lofted_top"});
  CHECK(made.blocks == std::vector<std::string>{"low", "", "high"});
  REQUIRE(made.facets.size() == 4);
  const TableFacet& node = made.facets[2];
  CHECK(node.surface == 0);
  CHECK(node.kind == 1);
  CHECK(node.block == 1);
  CHECK(node.element == 900);
  CHECK(node.side == 0);
  CHECK(made.facets[1].area == 1e-3);
  CHECK(made.facets[1].surface == 1);
  CHECK(made.has_facets);
  CHECK_FALSE(made.has_figures);
}

TEST_CASE("facets are of the surfaces that a table has already, others follow them", "[app][compare]") {
  OwnershipTable made = table_of_json(
      R"({"surfaces": [{"name": "x", "owned": 1, "lost_to": []}, {"name": "lid", "lost_to": []}]})");
  read_surfaces_csv("t.csv", std::string(facet_header) + "new,b,1,1,face,1\nlid,b,2,1,face,1\n", made);
  CHECK(surface_names(made) == std::vector<std::string>{"x", "lid", "new"});
  CHECK(made.facets[0].surface == 2);
  CHECK(made.facets[1].surface == 1);
  CHECK(made.surfaces[0].figures.size() == 1);
}

TEST_CASE("a list without facets is one", "[app][compare]") {
  const OwnershipTable made = facets_of("");
  CHECK(made.has_facets);
  CHECK(made.facets.empty());
  CHECK(made.surfaces.empty());
}

TEST_CASE("a line of facets that is not as it should be is named", "[app][compare]") {
  const auto message = [](const std::string& rows) -> std::string {
    try {
      facets_of(rows);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message("a,b,1,1,face,1\na,b,1,1,face\n") == "t.csv: line 3: 5 fields in place of 6");
  CHECK(message("a,b,1,1,face,1,\n") == "t.csv: line 2: 7 fields in place of 6");
  for (const char* row : {"a,b,one,1,face,1\n", "a,b,1,1.5,face,1\n", "a,b,1,1,face,\n", "a,b,,1,face,1\n",
                          "a,b,1,1,face,1x\n", "a,b,9223372036854775808,1,face,1\n"}) {
    INFO(row);
    CHECK(message(row) == "t.csv: line 2: element, side and area should be numbers");
  }
}
