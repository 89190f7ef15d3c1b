// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace contactsim {

namespace {

/// A binary file taken for a deck must not fill the memory with messages.
constexpr std::size_t max_control_characters_reported = 100;

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_comment_mark(char c) { return c == '#' || c == '$'; }
bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f; }
bool ends_word(char c) { return is_blank(c) || c == ',' || c == '=' || c == '<' || c == '>'; }
bool is_special(char c) { return is_control(c) || is_comment_mark(c) || c == '\\' || c == '"' || c == '\''; }

}  // namespace

std::size_t LogicalLine::source_offset(std::size_t position) const {
  const auto next =
      std::upper_bound(pieces.begin(), pieces.end(), position,
                       [](std::size_t value, const Piece& piece) { return value < piece.begin; });
  if (next == pieces.begin()) return 0;
  const Piece& piece = *std::prev(next);
  return piece.source + (position - piece.begin);
}

LineReader::LineReader(const Source& source, Diagnostics& diagnostics)
    : source_(source), diagnostics_(diagnostics), text_(source.text()) {}

bool LineReader::next(LogicalLine& line) {
  while (at_ < text_.size()) {
    line.text.clear();
    line.pieces.clear();
    line.quotes.clear();
    read_line(line);
    const auto is_separator = [](char c) { return is_blank(c) || c == ','; };
    if (!std::all_of(line.text.begin(), line.text.end(), is_separator)) return true;
  }
  return false;
}

void LineReader::read_line(LogicalLine& line) {
  while (at_ < text_.size() && text_[at_] != '\n') {
    const char c = text_[at_];
    if (is_comment_mark(c)) {
      skip_to_line_end();
    } else if (c == '\\') {
      if (!read_continuation(line, false)) copy(line, 1);
    } else if (is_control(c)) {
      report_control_character();
      add_blank(line);
      ++at_;
    } else if (opens_quote(line)) {
      read_quote(line);
    } else {
      read_plain(line);
    }
  }
  ++at_;
}

void LineReader::read_quote(LogicalLine& line) {
  const char quote = text_[at_];
  const std::size_t opened_at = at_;
  const std::size_t open = line.text.size();
  copy(line, 1);
  while (at_ < text_.size() && text_[at_] != '\n') {
    const char c = text_[at_];
    if (c == quote) {
      line.quotes.push_back({open, line.text.size()});
      copy(line, 1);
      return;
    }
    if (c == '\\' && read_continuation(line, true)) continue;
    if (is_control(c)) {
      report_control_character();
      ++at_;
    } else {
      copy(line, 1);
    }
  }
  diagnostics_.add_error(source_.locate(opened_at), fmt::format("the quote {} is never closed", quote),
                         "close it, or end the line with \\# to go on in the next one");
}

/// Reads \# or \$ and moves to the next line; false when the backslash is an ordinary character.
bool LineReader::read_continuation(LogicalLine& line, bool in_quote) {
  if (at_ + 1 >= text_.size() || !is_comment_mark(text_[at_ + 1])) return false;
  const bool may_continue = !in_quote || !is_closed_on_line('"');
  if (!may_continue) return false;
  if (!in_quote) add_blank(line);
  skip_to_line_end();
  at_ = std::min(at_ + 1, text_.size());
  return true;
}

void LineReader::read_plain(LogicalLine& line) {
  std::size_t n = 1;
  while (at_ + n < text_.size() && !is_special(text_[at_ + n])) ++n;
  copy(line, n);
}

void LineReader::copy(LogicalLine& line, std::size_t n_characters) {
  const bool continues = !line.pieces.empty() &&
                         line.pieces.back().source + (line.text.size() - line.pieces.back().begin) == at_;
  if (!continues) line.pieces.push_back({line.text.size(), at_});
  line.text += text_.substr(at_, n_characters);
  at_ += n_characters;
}

void LineReader::add_blank(LogicalLine& line) {
  line.pieces.push_back({line.text.size(), at_});
  line.text += ' ';
}

void LineReader::skip_to_line_end() { at_ = line_end(); }

std::size_t LineReader::line_end() {
  const bool is_known = line_end_ > at_ || (at_ < text_.size() && text_[at_] == '\n' && line_end_ == at_);
  if (!is_known) line_end_ = std::min(text_.find('\n', at_), text_.size());
  return line_end_;
}

/// A carriage return that ends a line is none.
void LineReader::report_control_character() {
  const char c = text_[at_];
  const bool ends_line = at_ + 1 == text_.size() || text_[at_ + 1] == '\n';
  if (c == '\r' && ends_line) return;
  if (++n_control_characters_ > max_control_characters_reported) return;
  diagnostics_.add_error(source_.locate(at_),
                         fmt::format("control character {:#04x} in the deck", static_cast<unsigned char>(c)));
}

bool LineReader::opens_quote(const LogicalLine& line) {
  const char c = text_[at_];
  if (c != '"' && c != '\'') return false;
  const bool at_word_start = line.text.empty() || ends_word(line.text.back());
  if (c == '"') return at_word_start || is_closed_on_line('"');
  return c == '\'' && at_word_start && is_closed_on_line('\'');
}

/// Whether the quote stands once more on this line, behind the present character.
bool LineReader::is_closed_on_line(char quote) {
  std::size_t& next = quote == '"' ? double_quote_ : single_quote_;
  if (next <= at_) next = text_.find(quote, at_ + 1);
  return next < line_end();
}

}  // namespace contactsim
