// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace contactsim {

namespace {

bool is_control(char c) { return (c >= 0 && c < 0x20) || c == 0x7f; }

/// What a deck says may be quoted in a message, which is one line for a terminal: control characters become
/// blanks.
std::string as_one_line(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

}  // namespace

void Diagnostics::add(Diagnostic diagnostic) {
  diagnostic.text = as_one_line(std::move(diagnostic.text));
  diagnostic.hint = as_one_line(std::move(diagnostic.hint));
  diagnostic.length = std::max(diagnostic.length, 1);
  if (diagnostic.severity == Severity::error) ++n_errors_;
  found_.push_back(std::move(diagnostic));
}

void Diagnostics::add_error(const DeckLocation& location, std::string text, std::string hint, int length) {
  add({Severity::error, "", location, length, std::move(text), std::move(hint)});
}

void Diagnostics::add_warning(std::string_view id, const DeckLocation& location, std::string text,
                              std::string hint, int length) {
  add({Severity::warning, std::string(id), location, length, std::move(text), std::move(hint)});
}

void Diagnostics::append(const Diagnostics& other) {
  for (const Diagnostic& diagnostic : other.found_) add(diagnostic);
}

namespace {

constexpr std::size_t max_of_kind = 20;

/// A text without its quoted words and its numbers.
std::string kind_of(std::string_view text) {
  std::string kind;
  bool is_quoted = false;
  for (const char c : text) {
    if (c == '\'') is_quoted = !is_quoted;
    const bool is_of_number = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
    if (!is_quoted && !is_of_number) kind += c;
  }
  return kind;
}

/// Counts what follows too many problems of one kind in a row.
std::vector<DiagnosticGroup> count_alike(std::vector<DiagnosticGroup> groups) {
  std::vector<DiagnosticGroup> kept;
  std::string kind;
  std::size_t n_of_kind = 0;
  for (DiagnosticGroup& group : groups) {
    const char* word = group.first.severity == Severity::error ? "error" : "warning";
    std::string own = fmt::format("{} {} {}", word, group.first.id, kind_of(group.first.text));
    n_of_kind = own == kind ? n_of_kind + 1 : 1;
    kind = std::move(own);
    if (n_of_kind <= max_of_kind) {
      kept.push_back(std::move(group));
    } else {
      kept.back().n_alike += 1 + group.others.size();
      kept.back().last_alike = group.first.location;
    }
  }
  return kept;
}

}  // namespace

std::vector<DiagnosticGroup> Diagnostics::grouped() const {
  std::map<const SourceFile*, int> file_order;
  for (const Diagnostic& d : found_) {
    if (d.location.is_known()) file_order.emplace(d.location.file.get(), static_cast<int>(file_order.size()));
  }
  const auto place = [&](const Diagnostic* d) {
    const bool known = d->location.is_known();
    return std::tuple(!known, known ? file_order.at(d->location.file.get()) : 0, d->location.line,
                      d->location.column);
  };
  std::vector<const Diagnostic*> order;
  for (const Diagnostic& d : found_) order.push_back(&d);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return place(a) < place(b); });

  std::vector<DiagnosticGroup> groups;
  std::map<std::tuple<Severity, std::string_view, std::string_view, std::string_view>, std::size_t> index;
  for (const Diagnostic* d : order) {
    const auto [found, is_new] = index.try_emplace({d->severity, d->id, d->text, d->hint}, groups.size());
    if (is_new) {
      groups.push_back({*d, {}});
    } else {
      groups[found->second].others.push_back(d->location);
    }
  }
  return count_alike(std::move(groups));
}

namespace {

constexpr std::size_t n_places_shown = 5;

std::string message(const Diagnostic& d) {
  std::string text = d.location.is_known() ? to_string(d.location) + ": " : "";
  text += d.severity == Severity::error ? "error: " : "warning: ";
  text += d.text;
  if (!d.hint.empty()) text += "; " + d.hint;
  if (!d.id.empty()) text += fmt::format(" [{}]", d.id);
  return text;
}

std::string trail_and_places(const DiagnosticGroup& group) {
  std::string text;
  for (const Trail* trail = group.first.location.trail.get(); trail != nullptr; trail = trail->outer.get()) {
    text += fmt::format("  {}\n", trail->text);
  }
  const auto alike = [&] {
    if (group.n_alike == 0) return std::string();
    const std::string last = group.last_alike.is_known() ? ", up to " + to_string(group.last_alike) : "";
    return fmt::format("  {} more of this kind{}\n", group.n_alike, last);
  };
  if (group.others.empty()) return text + alike();
  std::vector<std::string> places;
  for (const DeckLocation& other : group.others) {
    if (other.is_known() && places.size() + 1 < n_places_shown) places.push_back(to_string(other));
  }
  text += fmt::format("  {} more like this", group.others.size());
  if (!places.empty()) text += fmt::format(", at {}", fmt::join(places, ", "));
  if (places.size() < group.others.size() && !places.empty()) text += ", ...";
  return text + "\n" + alike();
}

std::string caret_picture(const Diagnostic& d) {
  std::string line = line_text(d.location);
  if (line.empty()) return "";
  const int column = std::clamp(d.location.column, 1, static_cast<int>(line.size()) + 1);
  const int room = std::max(1, static_cast<int>(line.size()) - column + 1);
  std::string under;
  for (int i = 0; i + 1 < column; ++i) under += line[static_cast<std::size_t>(i)] == '\t' ? '\t' : ' ';
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c != '\t' && is_control(c); }, ' ');
  under += '^';
  under += std::string(static_cast<std::size_t>(std::clamp(d.length, 1, room) - 1), '~');
  return fmt::format("    {}\n    {}\n", line, under);
}

}  // namespace

std::string format_machine(const DiagnosticGroup& group) {
  return message(group.first) + "\n" + trail_and_places(group);
}

std::string format_with_caret(const DiagnosticGroup& group, bool colour) {
  std::string head = message(group.first);
  if (colour) {
    const bool is_error = group.first.severity == Severity::error;
    const std::string word = is_error ? "error: " : "warning: ";
    const std::size_t at = head.find(word);
    head = fmt::format("\033[1m{}\033[{}m{}\033[0m{}", head.substr(0, at), is_error ? "31" : "35", word,
                       head.substr(at + word.size()));
  }
  return head + "\n" + caret_picture(group.first) + trail_and_places(group);
}

}  // namespace contactsim
