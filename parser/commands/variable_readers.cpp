// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/variable_readers.hpp"

#include <fmt/format.h>

#include <string_view>

#include "parser/text/word_grammar.hpp"

namespace contactsim {

namespace {

bool means_all(std::string_view part) { return part == ":" || part == "*"; }

std::int64_t integration_point(const Arguments& arguments, const Word& word, std::string_view text) {
  const auto point = find_integer(text);
  if (!point || *point < 1)
    arguments.fail(word, fmt::format("expected an integration point from 1, found '{}'", text));
  return *point;
}

}  // namespace

VariableReference read_variable(Arguments& arguments) {
  const Word& word = arguments.word("a variable");
  if (word.kind == WordKind::symbol || is_number(word.text)) {
    arguments.fail(word,
                   fmt::format("expected a variable after '{}', found '{}'", arguments.what(), word.text));
  }
  const auto parts = find_variable(word.text);
  if (!parts) {
    arguments.fail(
        word, fmt::format("expected <variable>(<component>,<integration point>), found '{}'", word.text));
  }
  VariableReference variable{{std::string(parts->name), word.location}, "", std::nullopt};
  if (!parts->component) return variable;
  if (parts->component->empty()) arguments.fail(word, fmt::format("expected a component in '{}'", word.text));
  if (!means_all(*parts->component)) variable.component = fold(*parts->component);
  if (parts->point && !means_all(*parts->point))
    variable.integration_point = integration_point(arguments, word, *parts->point);
  return variable;
}

VariableTest read_variable_test(Arguments& arguments) {
  VariableTest test{read_variable(arguments), Comparison::greater, 0.0};
  const Word& word = arguments.word("one of <, <=, =, >=, >");
  const auto comparison = find_comparison(word.text);
  if (!comparison) {
    arguments.fail(word, fmt::format("expected one of <, <=, =, >=, > after '{}', found '{}'",
                                     test.variable.name.text, word.text));
  }
  test.comparison = *comparison;
  test.value = arguments.real();
  return test;
}

VariableLocation read_location(Arguments& arguments) {
  using L = VariableLocation;
  static const Choices words({"nodal", "node", "element", "edge", "face", "global", "nodeset", "node set",
                              "surface", "sideset", "side set"});
  static constexpr L locations[] = {L::nodal,    L::nodal,    L::element,  L::edge,     L::face,    L::global,
                                    L::node_set, L::node_set, L::side_set, L::side_set, L::side_set};
  return locations[arguments.choice(words)];
}

}  // namespace contactsim
