// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/deck_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "core/base/names.hpp"
#include "parser/text/lines.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_include_depth = 32;
constexpr std::size_t max_included_files = 10000;
constexpr std::size_t max_included_characters = std::size_t{256} << 20;

Word make_word(const ParsedLine::Span& span, const LogicalLine& line, const Source& source) {
  const std::size_t quote = span.kind == WordKind::quoted ? 1 : 0;
  Word word{line.text.substr(span.begin + quote, span.end - span.begin - 2 * quote), span.kind,
            static_cast<std::uint32_t>(span.begin), source.locate(line.source_offset(span.begin))};
  if (span.kind == WordKind::bare) {
    // Only a group in parentheses brings blanks into a bare word.
    std::erase_if(word.text, [](char c) { return c == ' ' || c == '\t'; });
  }
  return word;
}

class Collector {
 public:
  Collector(Diagnostics& diagnostics, const FileReader& read_file)
      : diagnostics_(diagnostics), read_file_(read_file) {}

  void collect(const Source& source);
  std::vector<DeckLine> take() { return std::move(lines_); }

 private:
  void add_line(const LogicalLine& line, const ParsedLine& parsed, const Source& source);
  void include(const Command& command);
  std::string find_obstacle(const std::string& path, const DeckLocation& location) const;

  Diagnostics& diagnostics_;
  const FileReader& read_file_;
  std::vector<DeckLine> lines_;
  std::vector<std::string> open_paths_;
  std::size_t n_files_ = 0;
  std::size_t n_characters_ = 0;
};

void Collector::collect(const Source& source) {
  LineReader reader(source, diagnostics_);
  LogicalLine line;
  ParsedLine parsed;
  while (reader.next(line)) {
    parse_line(line, parsed);
    add_line(line, parsed, source);
  }
}

void Collector::add_line(const LogicalLine& line, const ParsedLine& parsed, const Source& source) {
  const bool is_command = parsed.kind == ParsedLine::Kind::command;
  if (is_command && parsed.words.empty()) return;
  DeckLine deck_line{parsed.kind, {}, {}};
  deck_line.command.words.reserve(parsed.words.size());
  for (const ParsedLine::Span& span : parsed.words) {
    deck_line.command.words.push_back(make_word(span, line, source));
  }
  deck_line.command.text = line.text;
  deck_line.location = is_command ? deck_line.command.words.front().location
                                  : source.locate(line.source_offset(parsed.keyword));
  const Word* first = is_command ? &deck_line.command.words.front() : nullptr;
  constexpr std::string_view keyword = "includefile";
  if (first && first->text.size() == keyword.size() && fold(first->text) == keyword) {
    include(deck_line.command);
  } else {
    lines_.push_back(std::move(deck_line));
  }
}

void Collector::include(const Command& command) {
  const std::size_t at = command.words.size() > 1 && command.words[1].text == "=" ? 2 : 1;
  const DeckLocation& location = command.words.front().location;
  if (command.words.size() != at + 1) {
    diagnostics_.add_error(location, "INCLUDEFILE takes one file name", "put a name with blanks in quotes",
                           11);
    return;
  }
  const Word& name = command.words[at];
  const int length = static_cast<int>(name.text.size());
  std::string problem = find_obstacle(name.text, location);
  TextFile file;
  if (problem.empty()) {
    file = read_file_(name.text);
    problem = file.problem;
  }
  if (!problem.empty()) {
    diagnostics_.add_error(name.location, fmt::format("cannot include '{}': {}", name.text, problem), "",
                           length);
    return;
  }
  ++n_files_;
  n_characters_ += file.text.size();
  const std::string where = fmt::format("included from {}:{}", location.file->name, location.line);
  const auto trail = std::make_shared<const Trail>(Trail{where, location.trail});
  open_paths_.push_back(name.text);
  collect(make_source(name.text, std::move(file.text), trail));
  open_paths_.pop_back();
}

/// Why the file may not be included here, or "".
std::string Collector::find_obstacle(const std::string& path, const DeckLocation& location) const {
  const auto is_same = [wanted = std::filesystem::path(path).lexically_normal()](const std::string& other) {
    return std::filesystem::path(other).lexically_normal() == wanted;
  };
  const bool is_open =
      is_same(location.file->name) || std::any_of(open_paths_.begin(), open_paths_.end(), is_same);
  if (is_open) return "the file includes itself";
  if (open_paths_.size() >= max_include_depth) {
    return fmt::format("includes are nested more than {} deep", max_include_depth);
  }
  const bool is_too_much = n_files_ >= max_included_files || n_characters_ >= max_included_characters;
  return is_too_much ? "too many files are included" : "";
}

}  // namespace

std::vector<DeckLine> read_deck_lines(const Source& source, Diagnostics& diagnostics,
                                      const FileReader& read_file) {
  Collector collector(diagnostics, read_file);
  collector.collect(source);
  return collector.take();
}

}  // namespace contactsim
