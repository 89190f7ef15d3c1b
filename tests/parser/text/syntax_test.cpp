// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/syntax.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

struct Parsed {
  Diagnostics diagnostics;
  Block deck;
};

Parsed parse(const std::string& text, const FileReader& read_file = read_no_file) {
  Parsed parsed;
  parsed.deck = parse_syntax(make_source("a.i", text), parsed.diagnostics, read_file);
  return parsed;
}

std::string tree(const std::string& text) {
  const Parsed parsed = parse(text);
  CHECK(messages(parsed.diagnostics) == "");
  return dump(parsed.deck);
}

std::string errors(const std::string& text) { return messages(parse(text).diagnostics); }

}  // namespace

TEST_CASE("blocks nest and keep the deck's order", "[parser][syntax]") {
  CHECK(tree("begin sierra Puck Game\n a = 1\n begin solid section s\n end solid section s\n b 2\nend "
             "sierra\nc\n") == "{sierra Puck Game\na [=] 1\n{solid section s\n}\nb 2\n}\nc\n");
}

TEST_CASE("END may be bare, partial, of another case, and hold underscores for blanks", "[parser][syntax]") {
  const std::string end =
      GENERATE("end", "END", "End Parameters", "end parameters for presto region",
               "end PARAMETERS FOR PRESTO REGION R", "end parameters_for presto_region r");
  CHECK(tree("begin parameters for presto region r\n" + end + "\n") ==
        "{parameters for presto region r\n}\n");
}

TEST_CASE("the names of a command's parts know where they stand", "[parser][syntax]") {
  const Parsed parsed = parse("begin a\n  surfaces = top, \\# comment\n\tbottom\nend");
  const Block& block = std::get<Block>(parsed.deck.items.at(0).value);
  const Command& command = std::get<Command>(block.items.at(0).value);
  CHECK(to_string(block.location) == "a.i:1:1");
  CHECK(to_string(block.title.at(0).location) == "a.i:1:7");
  CHECK(to_string(command.words.at(2).location) == "a.i:2:14");
  CHECK(to_string(command.words.at(3).location) == "a.i:3:2");
  CHECK(command.text.substr(command.words.at(2).begin) == "top,  \tbottom");
}

TEST_CASE("an END that another END replaces is reported once, at its BEGIN", "[parser][syntax]") {
  const std::string text =
      "begin presto region r\n"
      "  begin contact definition\n"
      "    search = dash\n"
      "  begin element death d\n"
      "  end\n"
      "  begin gravity\n"
      "  end\n"
      "end presto region r\n";
  const Parsed parsed = parse(text);
  CHECK(
      messages(parsed.diagnostics) ==
      "a.i:2:3: error: 'begin contact definition' has no END; it is missing before 'end presto region r' at "
      "a.i:8:1\n");
  CHECK(dump(parsed.deck) ==
        "{presto region r\n{contact definition\nsearch [=] dash\n}\n{element death d\n}\n{gravity\n}\n}\n");
  const Block& region = std::get<Block>(parsed.deck.items.at(0).value);
  CHECK(region.is_closed);
  CHECK_FALSE(std::get<Block>(region.items.at(0).value).is_closed);
}

TEST_CASE("with bare ENDs the indentation tells which is missing", "[parser][syntax]") {
  const Parsed parsed = parse("begin a\n  begin b\n    x\n  begin c\n    y\n  end\n  z\nend\n");
  CHECK(messages(parsed.diagnostics) ==
        "a.i:2:3: error: 'begin b' has no END; it is missing before the END at a.i:8:1\n");
  CHECK(dump(parsed.deck) == "{a\n{b\nx\n}\n{c\ny\n}\nz\n}\n");
}

TEST_CASE("a badly indented deck whose ENDs are complete is fine", "[parser][syntax]") {
  CHECK(tree("begin a\n      begin b\nend\n  end\n") == "{a\n{b\n}\n}\n");
}

TEST_CASE("without indentation a second block of one type shows that END is missing", "[parser][syntax]") {
  const Parsed parsed = parse(
      "begin contact definition\nbegin interaction a\nx\nbegin interaction b\ny\nend interaction b\n"
      "end contact definition\n");
  CHECK(parsed.diagnostics.error_count() == 1);
  CHECK(dump(parsed.deck) == "{contact definition\n{interaction a\nx\n}\n{interaction b\ny\n}\n}\n");
}

TEST_CASE("a deck that stops early names every open block", "[parser][syntax]") {
  CHECK(errors("begin sierra\nbegin material m\ndensity = 1") ==
        "a.i:1:1: error: 'begin sierra' has no END; the deck ends inside it\n"
        "a.i:2:1: error: 'begin material m' has no END; the deck ends inside it\n");
}

TEST_CASE("an END of another type closes the block and names both places", "[parser][syntax]") {
  const Parsed parsed = parse("begin sierra\n  begin interaction i\n  end contct\n  x\nend sierra\n");
  CHECK(messages(parsed.diagnostics) ==
        "a.i:3:3: error: 'end contct' does not close 'begin interaction i'; the block begins at a.i:2:3\n");
  CHECK(dump(parsed.deck) == "{sierra\n{interaction i\n}\nx\n}\n");
}

TEST_CASE("a stray END is dropped where the block's own END still comes", "[parser][syntax]") {
  const Parsed parsed =
      parse("begin sierra\n  begin region r\n    end gravity\n    x\n  end region\nend sierra\nend sierra\n");
  CHECK(messages(parsed.diagnostics) ==
        "a.i:3:5: error: 'end gravity' does not close 'begin region r'; the block begins at a.i:2:3\n"
        "a.i:7:1: error: 'end sierra' closes no block; every block before is closed\n");
  CHECK(dump(parsed.deck) == "{sierra\n{region r\nx\n}\n}\n");
}

TEST_CASE("BEGIN without a type is an error but still opens a block", "[parser][syntax]") {
  const Parsed parsed = parse("begin\nx\nend\ny\n");
  CHECK(messages(parsed.diagnostics) == "a.i:1:1: error: BEGIN needs the type of a block\n");
  CHECK(dump(parsed.deck) == "{\nx\n}\ny\n");
}

TEST_CASE("glued words are not cut", "[parser][syntax]") {
  CHECK(tree("begin sierrabeam\nend\nbeginsierra\nending\n") == "{sierrabeam\n}\nbeginsierra\nending\n");
}

TEST_CASE("blocks nested too deep are reported once and dropped", "[parser][syntax]") {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "begin b\n";
  text += "x\n";
  for (int i = 0; i < 100; ++i) text += "end b\n";
  text += "y\n";
  const Parsed parsed = parse(text);
  CHECK(messages(parsed.diagnostics) == "a.i:65:1: error: blocks are nested more than 64 deep\n");
  CHECK(std::get<Command>(parsed.deck.items.at(1).value).words.at(0).text == "y");
}

TEST_CASE("the errors of a deck of ENDs alone are counted, not collected", "[parser][syntax]") {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += fmt::format("end e{}\n", i);
  CHECK(parse(text).diagnostics.all().size() == 200);
}

TEST_CASE("an END with another name is a warning, with another type an error", "[parser][syntax]") {
  const auto check = [](const std::string& end) {
    const Parsed parsed = parse("begin contact surface top\n" + end + "\n");
    REQUIRE(messages(parsed.diagnostics) == "");
    Diagnostics found;
    check_end(std::get<Block>(parsed.deck.items.at(0).value), 2, found);
    return messages(found);
  };
  CHECK(check("end contact surface top") == "");
  CHECK(check("end CONTACT") == "");
  CHECK(
      check("end contact surface bottom") ==
      "a.i:2:5: warning: 'end contact surface bottom' has another name than 'begin contact surface top'; the "
      "block begins at a.i:1:1 [deck-end-name]\n");
  CHECK(check("end contact definition") ==
        "a.i:2:5: error: 'end contact definition' does not close 'begin contact surface top'; the block "
        "begins at "
        "a.i:1:1\n");
}

TEST_CASE("the lines of an INCLUDEFILE stand in its place and know the way", "[parser][syntax]") {
  const auto files = [](const std::string& path) -> TextFile {
    if (path == "rows.txt") return {"0 1 # one\n2, 3"};
    return {"", "there is no such file", TextFile::Failure::missing};
  };
  const Parsed parsed =
      parse("begin values\nIncludeFile rows.txt\n4 5\nend\nincludefile = 'none.txt'\n", files);
  CHECK(dump(parsed.deck) == "{values\n0 1\n2 3\n4 5\n}\n");
  const Block& values = std::get<Block>(parsed.deck.items.at(0).value);
  const DeckLocation& place = std::get<Command>(values.items.at(1).value).words.at(1).location;
  CHECK(to_string(place) == "rows.txt:2:4");
  REQUIRE(place.trail);
  CHECK(place.trail->text == "included from a.i:2");
  CHECK(messages(parsed.diagnostics) ==
        "a.i:5:15: error: cannot include 'none.txt': there is no such file\n");
}

TEST_CASE("INCLUDEFILE refuses rings, depth and malformed lines", "[parser][syntax]") {
  const auto ring = [](const std::string& path) -> TextFile {
    return {path == "b" ? "includefile ./c" : "includefile b"};
  };
  CHECK(messages(parse("includefile b", ring).diagnostics) ==
        "./c:1:13: error: cannot include 'b': the file includes itself\n  included from b:1\n  included from "
        "a.i:1\n");
  CHECK(messages(parse("includefile a.i", ring).diagnostics) ==
        "a.i:1:13: error: cannot include 'a.i': the file includes itself\n");
  const auto deeper = [](const std::string& path) -> TextFile { return {"includefile " + path + "x"}; };
  CHECK(messages(parse("includefile x", deeper).diagnostics).find("nested more than 32 deep") !=
        std::string::npos);
  CHECK(errors("includefile") ==
        "a.i:1:1: error: INCLUDEFILE takes one file name; put a name with blanks in quotes\n");
  CHECK(errors("includefile a b").find("takes one file name") != std::string::npos);
  const auto many = [](const std::string& path) -> TextFile {
    return {"includefile " + path + "1\nincludefile " + path + "2\n"};
  };
  CHECK(messages(parse("includefile x", many).diagnostics).find("too many files") != std::string::npos);
}
