// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/arguments.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "parser/text/phrases.hpp"

namespace contactsim {

namespace {

int underline(const Word& word) {
  return static_cast<int>(word.text.size()) + (word.kind == WordKind::quoted ? 2 : 0);
}

std::string quote(const Word& word) { return fmt::format("'{}'", word.text); }

}  // namespace

std::optional<double> find_real(std::string_view text) {
  const bool is_signed = text.starts_with('+') || text.starts_with('-');
  const std::string_view digits = text.substr(is_signed ? 1 : 0);
  std::string plain(text.substr(text.starts_with('+') ? 1 : 0));
  const bool starts_well =
      !digits.empty() && (std::isdigit(static_cast<unsigned char>(digits[0])) || digits[0] == '.');
  if (!starts_well) return std::nullopt;
  for (char& c : plain) {
    if (c == 'd' || c == 'D') c = 'e';
  }
  double value = 0.0;
  const char* end = plain.data() + plain.size();
  const auto [stop, error] = std::from_chars(plain.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_number(std::string_view text) { return find_real(text).has_value(); }

Arguments::Arguments(std::string what, std::span<const Word> words, const Command& command,
                     const DeckLocation& location)
    : what_(std::move(what)), words_(words), command_(&command), location_(location) {
  skip_separator();
}

void Arguments::skip_separator() {
  if (at_end()) return;
  if (peek().kind == WordKind::symbol ? peek().text == "=" : is_next("is") || is_next("are")) ++next_;
}

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
  return words_[next_++];
}

double Arguments::real() {
  const Word& number = word("a number");
  const auto value = find_real(number.text);
  if (!value || number.kind == WordKind::symbol) {
    fail(number, fmt::format("expected a number for '{}', found {}", what_, quote(number)));
  }
  return *value;
}

double Arguments::positive() {
  const std::size_t at = next_;
  const double value = real();
  if (!(value > 0.0))
    fail(words_[at], fmt::format("'{}' must be greater than 0, found {}", what_, quote(words_[at])));
  return value;
}

double Arguments::non_negative() {
  const std::size_t at = next_;
  const double value = real();
  if (!(value >= 0.0))
    fail(words_[at], fmt::format("'{}' must not be negative, found {}", what_, quote(words_[at])));
  return value;
}

std::int64_t Arguments::integer() {
  const Word& number = word("an integer");
  const std::string_view text = std::string_view(number.text).substr(number.text.starts_with('+') ? 1 : 0);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) {
    fail(number, fmt::format("expected an integer for '{}', found {}", what_, quote(number)));
  }
  return value;
}

std::int64_t Arguments::positive_integer() {
  const std::size_t at = next_;
  const std::int64_t value = integer();
  if (value <= 0)
    fail(words_[at], fmt::format("'{}' must be at least 1, found {}", what_, quote(words_[at])));
  return value;
}

std::int64_t Arguments::non_negative_integer() {
  const std::size_t at = next_;
  const std::int64_t value = integer();
  if (value < 0)
    fail(words_[at], fmt::format("'{}' must not be negative, found {}", what_, quote(words_[at])));
  return value;
}

bool Arguments::on_off() {
  static const std::string choices[] = {"on", "true", "yes", "off", "false", "no"};
  return choice(choices) < 3;
}

DeckName Arguments::name() {
  const Word& found = word("a name");
  if (found.kind == WordKind::symbol)
    fail(found, fmt::format("expected a name after '{}', found {}", what_, quote(found)));
  return {found.text, found.location};
}

DeckName Arguments::reference(NameKind kind) {
  notes_.referred.push_back({kind, name()});
  return notes_.referred.back().name;
}

std::vector<DeckName> Arguments::references(NameKind kind) {
  std::vector<DeckName> list{reference(kind)};
  while (!at_end()) list.push_back(reference(kind));
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
  next_ = words_.size();
  return std::string(rest);
}

std::string Arguments::all() {
  next_ = 0;
  return rest();
}

Eigen::Vector3d Arguments::vector() {
  const double x = real(), y = real(), z = real();
  return {x, y, z};
}

std::vector<DeckName> Arguments::names() {
  std::vector<DeckName> list{name()};
  while (!at_end()) list.push_back(name());
  return list;
}

std::vector<double> Arguments::reals() {
  std::vector<double> list{real()};
  while (!at_end()) list.push_back(real());
  return list;
}

std::vector<std::int64_t> Arguments::integers() {
  std::vector<std::int64_t> list{integer()};
  while (!at_end()) list.push_back(integer());
  return list;
}

bool Arguments::is_next(std::string_view keyword) const {
  return !at_end() && peek().kind == WordKind::bare && fold(peek().text) == keyword;
}

bool Arguments::accept(std::string_view keyword) {
  if (!is_next(keyword)) return false;
  ++next_;
  return true;
}

void Arguments::expect(std::string_view keyword) {
  if (accept(keyword)) return;
  const std::string found = at_end() ? "the end of the line" : quote(peek());
  const std::string wanted[] = {std::string(keyword)};
  fail_here(fmt::format("expected '{}' in '{}', found {}", keyword, what_, found),
            at_end() ? "" : suggest(peek().text, wanted));
}

std::size_t Arguments::choice(std::span<const std::string> choices) {
  std::size_t best = choices.size(), best_words = 0;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const std::size_t n = match_phrase(split_phrase(choices[i]), words_.subspan(next_));
    if (n > best_words) {
      best = i;
      best_words = n;
    }
  }
  if (best == choices.size()) {
    const std::string legal = fmt::format("{}", fmt::join(choices, ", "));
    const Word& found = word("one of " + legal);
    fail(found, fmt::format("expected one of {} for '{}', found {}", legal, what_, quote(found)),
         suggest(found.text, choices));
  }
  next_ += best_words;
  return best;
}

void Arguments::expect_end() {
  if (at_end()) return;
  fail_here(fmt::format("'{}' takes no more words, found {}", what_, quote(peek())));
}

}  // namespace contactsim
