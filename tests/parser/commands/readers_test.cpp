// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/readers.hpp"

#include <cmath>
#include <limits>

#include "core/definition/expression.hpp"
#include "support/deck_line.hpp"

using namespace contactsim;

namespace {

/// What a reader says of the words behind "size".
template <class V>
std::string said_by(const Reader<V>& reader, const std::string& words) {
  const Command command = command_of("size " + words);
  Diagnostics said;
  try {
    Arguments arguments("size", std::span(command.words).subspan(1), command, command.words[0].location);
    reader.read(arguments);
    arguments.expect_end();
  } catch (const ArgumentError& error) {
    said.add(error.diagnostic);
  }
  return messages(said);
}

template <class V>
V value_by(const Reader<V>& reader, const std::string& words) {
  const Command command = command_of("size " + words);
  Arguments arguments("size", std::span(command.words).subspan(1), command, command.words[0].location);
  return reader.read(arguments);
}

enum class Mood { good, very_bad };

}  // namespace

TEST_CASE("a default is shown as a deck would have it", "[parser][readers]") {
  CHECK(read::real.show(0.1) == "0.1");
  CHECK(read::real.show(std::nan("")) == "required");
  CHECK(read::positive_integer.show(7) == "7");
  CHECK(read::on_off.show(true) == "ON");
  CHECK(read::on_off.show(false) == "OFF");
  CHECK(read::vector3.show(Eigen::Vector3d::Zero()) == "none");
}

TEST_CASE("a share is a number from 0 to 1", "[parser][readers]") {
  CHECK(value_by(read::share, "= 0") == 0.0);
  CHECK(value_by(read::share, "1.0") == 1.0);
  CHECK(said_by(read::share, "1.01") == "a.i:1:6: error: 'size' must be from 0 to 1, found '1.01'\n");
  CHECK(said_by(read::share, "= -1e-9") == "a.i:1:8: error: 'size' must be from 0 to 1, found '-1e-9'\n");
  CHECK(said_by(read::share, "") ==
        "a.i:1:1: error: expected a number after 'size', found the end of the line\n");
}

TEST_CASE("a choice is an enumerator by its place, of one word or of several", "[parser][readers]") {
  const Reader<Mood> mood = choice_of<Mood>({"good", "very bad"});
  CHECK(mood.syntax == "{good|very bad}");
  CHECK(value_by(mood, "= Very_Bad") == Mood::very_bad);
  CHECK(value_by(mood, "GOOD") == Mood::good);
  CHECK(mood.show(Mood::very_bad) == "very bad");
  CHECK(said_by(mood, "godo").find("did you mean 'good'?") != std::string::npos);
}

TEST_CASE("readers of names say what these stand for", "[parser][readers]") {
  const Reader<DeckName> function = read::name_of(NameKind::function);
  CHECK(function.syntax == "<function>");
  CHECK(function.references == NameKind::function);
  CHECK(value_by(function, "= ramp").text == "ramp");
  const Reader<std::vector<DeckName>> blocks = read::names_of(NameKind::block);
  CHECK(blocks.syntax == "<block> ...");
  CHECK(value_by(blocks, "a, b c").size() == 3);
  CHECK(read::names_of_or_all(NameKind::block).syntax == "<block> ... or ALL");
}

TEST_CASE("ALL stands for nothing that is defined", "[parser][readers]") {
  const Command command = command_of("size all b");
  Arguments arguments("size", std::span(command.words).subspan(1), command, command.words[0].location);
  CHECK(read::names_of_or_all(NameKind::block).read(arguments).size() == 2);
  REQUIRE(arguments.notes().referred.size() == 1);
  CHECK(arguments.notes().referred[0].name.text == "b");
}

TEST_CASE("an expression is what stands between quotes, or the rest of the line", "[parser][readers]") {
  const auto expression_of = [](const std::string& line) {
    const Command command = command_of(line);
    Arguments arguments("is", std::span(command.words).subspan(1), command, command.words[0].location);
    return read_expression(arguments);
  };
  const DeckExpression quoted = expression_of("is \"2 * x\"");
  CHECK(quoted.text == "2 * x");
  CHECK_FALSE(quoted.error);
  CHECK(to_string(quoted.location) == "a.i:1:4");
  CHECK(expression_of("is 2 * x").text == "2 * x");
  CHECK(expression_of("is \"2 *\"").error.has_value());  // for whoever uses it
  CHECK_THROWS_AS(expression_of("is"), ArgumentError);
  CHECK_THROWS_AS(expression_of("is \"\""), ArgumentError);
}
