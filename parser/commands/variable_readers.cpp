// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/variable_readers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace contactsim {

namespace {

bool means_all(std::string_view part) { return part == ":" || part == "*"; }

std::int64_t integration_point(const Arguments& arguments, const Word& word, std::string_view text) {
  std::int64_t point = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), point);
  if (error != std::errc() || stop != text.data() + text.size() || point < 1) {
    arguments.fail(word, fmt::format("expected an integration point from 1, found '{}'", text));
  }
  return point;
}

/// Takes "(c)" or "(c,ip)" apart.
void read_parentheses(const Arguments& arguments, const Word& word, std::string_view group,
                      VariableReference& variable) {
  const std::string_view inside = group.substr(1, group.size() - 2);
  const std::size_t comma = inside.find(',');
  const std::string_view component = inside.substr(0, comma);
  if (component.empty()) arguments.fail(word, fmt::format("expected a component in '{}'", word.text));
  if (!means_all(component)) variable.component = fold(component);
  if (comma == std::string_view::npos) return;
  const std::string_view point = inside.substr(comma + 1);
  if (!means_all(point)) variable.integration_point = integration_point(arguments, word, point);
}

}  // namespace

VariableReference read_variable(Arguments& arguments) {
  const Word& word = arguments.word("a variable");
  if (word.kind == WordKind::symbol || is_number(word.text)) {
    arguments.fail(word,
                   fmt::format("expected a variable after '{}', found '{}'", arguments.what(), word.text));
  }
  const std::size_t open = word.text.find('(');
  VariableReference variable{{word.text.substr(0, open), word.location}, "", std::nullopt};
  if (open == std::string::npos) return variable;
  if (open == 0 || word.text.back() != ')') {
    arguments.fail(
        word, fmt::format("expected <variable>(<component>,<integration point>), found '{}'", word.text));
  }
  read_parentheses(arguments, word, std::string_view(word.text).substr(open), variable);
  return variable;
}

VariableTest read_variable_test(Arguments& arguments) {
  VariableTest test{read_variable(arguments), Comparison::greater, 0.0};
  const Word& word = arguments.word("one of <, <=, =, >=, >");
  const std::string_view op = word.text;
  if (op == "<") {
    test.comparison = Comparison::less;
  } else if (op == "<=") {
    test.comparison = Comparison::less_equal;
  } else if (op == "=" || op == "==") {
    test.comparison = Comparison::equal;
  } else if (op == ">=") {
    test.comparison = Comparison::greater_equal;
  } else if (op != ">") {
    arguments.fail(word, fmt::format("expected one of <, <=, =, >=, > after '{}', found '{}'",
                                     test.variable.name.text, op));
  }
  test.value = arguments.real();
  return test;
}

VariableLocation read_location(Arguments& arguments) {
  using L = VariableLocation;
  static const std::string words[] = {"nodal",   "node",     "element", "edge",    "face",    "global",
                                      "nodeset", "node set", "surface", "sideset", "side set"};
  static constexpr L locations[] = {L::nodal,    L::nodal,    L::element,  L::edge,     L::face,    L::global,
                                    L::node_set, L::node_set, L::side_set, L::side_set, L::side_set};
  return locations[arguments.choice(words)];
}

}  // namespace contactsim
