// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/block_rows.hpp"

#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

struct Wing {
  DeckName name;
  double span = 0.0;
};

struct Plane {
  DeckName name;
  double span = 0.0;
  std::vector<Wing> wings;
  Wing tail;
};

const Table<Wing>& wing_table() {
  static const Table<Wing> table({row("span", read::positive, &Wing::span, "Span [length]")});
  return table;
}

const Table<Plane>& plane_table();

const Table<Plane>& engine_table() {
  static const Table<Plane> table({row("span", read::positive, &Plane::span, "Span [length]")});
  return table;
}

const Table<Plane>& plane_table() {
  static const Table<Plane> table({
      block("wing", Naming::required, wing_table, &Plane::wings, "A wing"),
      block("tail", Naming::none, wing_table, &Plane::tail, "The tail"),
      block_into<Plane>("body", Naming::optional, engine_table, "Its body"),
      ignored_block<Plane>("paint", "Paint weighs nothing"),
      ignored_block<Plane>(
          "curtain", []() -> const TableText& { return wing_table().text(); }, "Nobody looks"),
      refused_block<Plane>("rotor", "take a helicopter"),
      lift(row("span", read::positive, &Wing::span, "Of the tail [length]"), &Plane::tail),
  });
  return table;
}

struct BoundPlane {
  Plane plane;
  std::string said;
};

BoundPlane bound_plane(const std::string& lines) {
  const Block deck = block_of("begin plane\n" + lines + "end\n");
  BoundPlane bound;
  Diagnostics said;
  Binding binding{said, false};
  plane_table().bind(std::get<Block>(deck.items.at(0).value), bound.plane, binding);
  bound.said = messages(said);
  return bound;
}

}  // namespace

TEST_CASE("a block of a list has its name at its place, one of several", "[parser][rows]") {
  const BoundPlane bound = bound_plane("begin wing left\nspan = 2\nend\nbegin wing right\nend\n");
  CHECK(bound.said == "");
  REQUIRE(bound.plane.wings.size() == 2);
  CHECK(bound.plane.wings[0].name.text == "left");
  CHECK(to_string(bound.plane.wings[0].name.location) == "a.i:2:12");
  CHECK(bound.plane.wings[0].span == 2.0);
  CHECK(bound.plane.wings[1].span == 0.0);
}

TEST_CASE("a part that is there once takes the lines of all its blocks", "[parser][rows]") {
  const BoundPlane bound = bound_plane("begin tail\nspan = 2\nend\nbegin tail\nend\n");
  CHECK(bound.said == "");
  CHECK(bound.plane.tail.span == 2.0);
  CHECK(bound_plane("begin body\nspan = 3\nend\n").plane.span == 3.0);
  CHECK(bound_plane("begin body b\nspan = 4\nend\n").plane.span == 4.0);
  CHECK(bound_plane("span = 5\n").plane.tail.span == 5.0);  // a row that was lifted
}

TEST_CASE("a block that must have a name and has none is reported at its last word", "[parser][rows]") {
  CHECK(bound_plane("begin wing\nspan = 2\nend\n").said == "a.i:2:7: error: the block 'wing' needs a name\n");
  CHECK(bound_plane("begin wing\nend\n").plane.wings.empty());
}

TEST_CASE("what an ignored or a refused block holds is not read", "[parser][rows]") {
  CHECK(bound_plane("begin paint\nnonsense = 1\nend\n").said ==
        "a.i:2:7: warning: block 'paint' has no effect here; paint weighs nothing [deck-ignored]\n");
  CHECK(bound_plane("begin curtain c\nspan = -1\nend\n")
            .said.starts_with("a.i:2:7: warning: block 'curtain' has no effect"));
  const std::string refused = bound_plane("begin rotor\nspan = -1\nend\n").said;
  CHECK(refused ==
        "a.i:2:7: error: block 'rotor' is not supported and would change the answer; take a helicopter\n");
}

TEST_CASE("rows of blocks say how these are named, and what is in them", "[parser][rows]") {
  const std::vector<RowText>& rows = plane_table().text().rows;
  CHECK(syntax_of(Naming::none) == "");
  CHECK(rows[0].syntax == "<name>");
  CHECK(rows[1].syntax == "");
  CHECK(rows[2].syntax == "[<name>]");
  CHECK(rows[0].is_block);
  CHECK(&rows[0].contents() == &wing_table().text());
  CHECK_FALSE(rows[3].contents);
  CHECK(&rows[4].contents() == &wing_table().text());
  CHECK(rows[5].support == Support::refused);
  CHECK_FALSE(rows[6].is_block);
}
