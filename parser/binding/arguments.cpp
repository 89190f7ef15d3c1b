// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/arguments.hpp"
#include "parser/text/word_grammar.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

int underline(const Word& word) {
  return static_cast<int>(word.text.size()) + (word.kind == WordKind::quoted ? 2 : 0);
}

std::string quote(const Word& word) { return fmt::format("'{}'", word.text); }

}  // namespace

Arguments::Arguments(std::string what, Words words, const Command& command, const DeckLocation& location)
    : what_(std::move(what)), line_(words), words_(words), command_(&command), location_(location) {
  skip_separator();
}

void Arguments::skip_separator() { take_separator(words_); }

void Arguments::warn(std::string_view id, const Word& at, std::string text, std::string hint) {
  warnings_.push_back(
      {Severity::warning, std::string(id), at.location, underline(at), std::move(text), std::move(hint)});
}

void Arguments::refuse(const Word& at, std::string text, std::string hint) const {
  throw ArgumentError{{Severity::error, "", at.location, underline(at), std::move(text), std::move(hint)},
                      true};
}

void Arguments::fail(const Word& at, std::string text, std::string hint) const {
  throw ArgumentError{{Severity::error, "", at.location, underline(at), std::move(text), std::move(hint)}};
}

void Arguments::fail_here(std::string text, std::string hint) const {
  if (!at_end()) fail(peek(), std::move(text), std::move(hint));
  throw ArgumentError{
      {Severity::error, "", location_, static_cast<int>(what_.size()), std::move(text), std::move(hint)}};
}

const Word& Arguments::word(std::string_view expected) {
  if (at_end()) fail_here(fmt::format("expected {} after '{}', found the end of the line", expected, what_));
  const Word& next = words_.front();
  words_ = words_.subspan(1);
  return next;
}

template <class V>
V Arguments::read(V (*take)(Words&), std::string_view relation) {
  try {
    return take(words_);
  } catch (const ValueError& error) {
    const Word& found = word(error.expected);
    fail(found, fmt::format("expected {} {} '{}', found {}", error.expected, relation, what_, quote(found)));
  }
}

void Arguments::require(bool holds, const Word& at, std::string_view must) const {
  if (!holds) fail(at, fmt::format("'{}' must {}, found {}", what_, must, quote(at)));
}

double Arguments::real() { return read(take_real); }

double Arguments::positive() {
  const Words before = words_;
  const double value = real();
  require(value > 0.0, before.front(), "be greater than 0");
  return value;
}

double Arguments::non_negative() {
  const Words before = words_;
  const double value = real();
  require(value >= 0.0, before.front(), "not be negative");
  return value;
}

std::int64_t Arguments::integer() { return read(take_integer); }

std::int64_t Arguments::positive_integer() {
  const Words before = words_;
  const std::int64_t value = integer();
  require(value >= 1, before.front(), "be at least 1");
  return value;
}

std::int64_t Arguments::non_negative_integer() {
  const Words before = words_;
  const std::int64_t value = integer();
  require(value >= 0, before.front(), "not be negative");
  return value;
}

bool Arguments::on_off() {
  static const Choices choices({"on", "true", "yes", "off", "false", "no"});
  return choice(choices) < 3;
}

DeckName Arguments::name() { return read(take_name, "after"); }

DeckName Arguments::reference(NameKind kind) {
  if (kind == NameKind::direction && words_.size() > 1 && is_number(peek().text))
    fail_here(fmt::format("expected the name of a direction after '{}', found {}", what_, quote(peek())),
              "DEFINE DIRECTION <name> WITH VECTOR <x> <y> <z> at the top of the deck gives it one");
  notes_.referred.push_back({kind, name()});
  return notes_.referred.back().name;
}

std::vector<DeckName> Arguments::references(NameKind kind, std::string_view word) {
  std::vector<DeckName> list = names();
  for (const DeckName& name : list) {
    if (fold(name.text) != word) notes_.referred.push_back({kind, name});
  }
  return list;
}

DeckName Arguments::definition(NameKind kind) {
  define(kind, name());
  return notes_.defined.back().name;
}

std::string Arguments::text() { return name().text; }

std::string Arguments::rest() {
  if (at_end()) return "";
  std::string_view rest = std::string_view(command_->text).substr(peek().begin);
  while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t')) rest.remove_suffix(1);
  words_ = {};
  return std::string(rest);
}

std::string Arguments::all() {
  words_ = line_;
  return rest();
}

Eigen::Vector3d Arguments::vector() { return read(take_vector); }

std::vector<DeckName> Arguments::names() { return read(take_names, "after"); }

std::vector<double> Arguments::reals() { return read(take_reals); }

std::vector<std::int64_t> Arguments::integers() { return read(take_integers); }

bool Arguments::is_next(std::string_view keyword) const {
  Words ahead = words_;
  return take_keyword(ahead, keyword);
}

bool Arguments::accept(std::string_view keyword) { return take_keyword(words_, keyword); }

void Arguments::expect(std::string_view keyword) {
  if (accept(keyword)) return;
  const std::string found = at_end() ? "the end of the line" : quote(peek());
  const std::string wanted[] = {std::string(keyword)};
  fail_here(fmt::format("expected '{}' in '{}', found {}", keyword, what_, found),
            at_end() ? "" : suggest(peek().text, wanted));
}

std::size_t Arguments::choice(const Choices& choices) {
  if (const auto position = take_choice(words_, choices)) return *position;
  const std::string legal = fmt::format("{}", fmt::join(choices.phrases(), ", "));
  const Word& found = word("one of " + legal);
  const auto is_it = [&](const std::string& phrase) { return fold(phrase) == fold(found.text); };
  const bool is_right_but_quoted =
      found.kind == WordKind::quoted && std::ranges::any_of(choices.phrases(), is_it);
  fail(found, fmt::format("expected one of {} for '{}', found {}", legal, what_, quote(found)),
       is_right_but_quoted ? "write it without quotes" : suggest(found.text, choices.phrases()));
}

void Arguments::expect_end() {
  if (at_end()) return;
  fail_here(fmt::format("'{}' takes no more words, found {}", what_, quote(peek())));
}

}  // namespace contactsim
