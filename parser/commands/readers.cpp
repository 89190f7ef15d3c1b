// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/readers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "parser/text/expression_grammar.hpp"

namespace contactsim {

namespace {

std::string show_real(double value) { return std::isnan(value) ? "required" : fmt::format("{}", value); }
std::string show_integer(std::int64_t value) { return fmt::format("{}", value); }
std::string show_text(const std::string& value) { return value.empty() ? "none" : value; }

template <class V>
std::string show_none(const V&) {
  return "none";
}

}  // namespace

namespace read {

const Reader<double> real{"<real>", &Arguments::real, show_real};
const Reader<double> positive{"<real > 0>", &Arguments::positive, show_real};
const Reader<double> non_negative{"<real >= 0>", &Arguments::non_negative, show_real};
const Reader<double> share{"<real 0 to 1>",
                           [](Arguments& arguments) {
                             const Word* written = arguments.at_end() ? nullptr : &arguments.peek();
                             const double value = arguments.real();
                             if (value < 0.0 || value > 1.0)
                               arguments.fail(*written, fmt::format("'{}' must be from 0 to 1, found '{}'",
                                                                    arguments.what(), written->text));
                             return value;
                           },
                           [](const double& value) { return fmt::format("{}", value); }};
const Reader<std::int64_t> integer{"<integer>", &Arguments::integer, show_integer};
const Reader<std::int64_t> positive_integer{"<integer > 0>", &Arguments::positive_integer, show_integer};
const Reader<std::int64_t> non_negative_integer{"<integer >= 0>", &Arguments::non_negative_integer,
                                                show_integer};
const Reader<bool> on_off{"{ON|OFF}", &Arguments::on_off, [](bool value) { return value ? "ON" : "OFF"; }};
const Reader<DeckName> name{"<name>", &Arguments::name,
                            [](const DeckName& value) { return show_text(value.text); }};
const Reader<std::string> text{"<text>", &Arguments::text, show_text};
const Reader<std::string> rest_of_line{"<rest of the line>", &Arguments::rest, show_text};
const Reader<Eigen::Vector3d> vector3{"<x> <y> <z>", &Arguments::vector, show_none<Eigen::Vector3d>};
const Reader<std::vector<DeckName>> names{"<name> ...", &Arguments::names, show_none<std::vector<DeckName>>};
const Reader<std::vector<double>> reals{"<real> ...", &Arguments::reals, show_none<std::vector<double>>};
const Reader<std::vector<std::int64_t>> integers{"<integer> ...", &Arguments::integers,
                                                 show_none<std::vector<std::int64_t>>};

Reader<DeckName> name_of(NameKind kind) {
  return {fmt::format("<{}>", text_of(kind).word),
          [kind](Arguments& arguments) { return arguments.reference(kind); }, name.show, kind};
}

Reader<std::vector<DeckName>> names_of(NameKind kind) {
  return {fmt::format("<{}> ...", text_of(kind).word),
          [kind](Arguments& arguments) { return arguments.references(kind); }, names.show, kind};
}

Reader<std::vector<DeckName>> names_of_or_all(NameKind kind) {
  return {fmt::format("<{}> ... or ALL", text_of(kind).word),
          [kind](Arguments& arguments) { return arguments.references(kind, "all"); }, names.show, kind};
}

}  // namespace read

DeckExpression read_expression(Arguments& arguments) {
  DeckLocation location = arguments.at_end() ? arguments.location() : arguments.peek().location;
  std::string text;
  if (!arguments.at_end())
    text = arguments.peek().kind == WordKind::quoted ? arguments.text() : arguments.rest();
  if (text.empty()) arguments.fail_here("expected an expression between double quotes");
  return read_deck_expression(std::move(location), std::move(text));
}

std::string syntax_of_choice(const Choices& choices) {
  return fmt::format("{{{}}}", fmt::join(choices.phrases(), "|"));
}

}  // namespace contactsim
