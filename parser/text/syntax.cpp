// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/syntax.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "parser/text/deck_lines.hpp"
#include "parser/text/phrases.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_depth = 64;
constexpr std::size_t max_errors = 200;
constexpr std::size_t max_lines_looked_ahead = 10000;

using Kind = ParsedLine::Kind;
using Phrase = std::vector<std::string>;

/// The words in the spelling by which titles are compared, cut at underscores as keywords are.
Phrase spelling(std::span<const Word> words) {
  Phrase parts;
  for (const Word& word : words) {
    for (std::string& part : split_phrase(word.text)) parts.push_back(std::move(part));
  }
  return parts;
}

std::size_t count_common(const Phrase& a, const Phrase& b) {
  const auto [end, unused] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end - a.begin());
}

std::string shown(std::string_view keyword, std::span<const Word> words) {
  std::string text = fmt::format("'{}", keyword);
  for (const Word& word : words) text += " " + word.text;
  return text + "'";
}

int length_of(std::string_view keyword, std::span<const Word> words) {
  return static_cast<int>(shown(keyword, words).size()) - 2;
}

bool is_balanced(std::span<const DeckLine> lines) {
  std::ptrdiff_t depth = 0;
  for (const DeckLine& line : lines) {
    if (line.kind == Kind::begin) ++depth;
    if (line.kind == Kind::end && --depth < 0) return false;
  }
  return depth == 0;
}

/// Puts lines into blocks by BEGIN and END.
class TreeBuilder {
 public:
  TreeBuilder(std::vector<DeckLine> lines, Diagnostics& diagnostics)
      : lines_(std::move(lines)), diagnostics_(diagnostics), is_balanced_(is_balanced(lines_)) {}

  Block build();

 private:
  void open(DeckLine& line);
  void close(std::size_t at);
  void close_titled(std::size_t at, const Phrase& title);
  void close_mismatched(std::size_t at, const Phrase& title);
  void close_unfinished(std::size_t n_kept, const std::string& hint);
  void close_innermost();
  bool is_needed_later(std::size_t at) const;
  std::size_t find_by_column(int column) const;
  void report(const DeckLocation& location, std::string text, std::string hint, int length);

  std::vector<DeckLine> lines_;
  Diagnostics& diagnostics_;
  bool is_balanced_;
  std::vector<Block> open_{1};  ///< the deck's outermost level first
  std::size_t n_too_deep_ = 0;  ///< open blocks past the greatest depth, which are dropped
  std::size_t n_errors_ = 0;
};

Block TreeBuilder::build() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    DeckLine& line = lines_[i];
    if (line.kind == Kind::begin) {
      open(line);
    } else if (line.kind == Kind::end) {
      close(i);
    } else if (n_too_deep_ == 0) {
      open_.back().items.push_back({std::move(line.command)});
    }
  }
  close_unfinished(1, "the deck ends inside it");
  return std::move(open_.front());
}

void TreeBuilder::open(DeckLine& line) {
  auto& title = line.command.words;
  if (title.empty()) report(line.location, "BEGIN needs the type of a block", "", 5);
  const bool is_too_deep = open_.size() > max_depth;
  if (is_too_deep && n_too_deep_ == 0) {
    report(line.location, fmt::format("blocks are nested more than {} deep", max_depth), "",
           length_of("begin", title));
  }
  if (is_too_deep) {
    ++n_too_deep_;
  } else {
    open_.push_back({std::move(title), line.location, {}, {}, true});
  }
}

void TreeBuilder::close(std::size_t at) {
  DeckLine& line = lines_[at];
  const auto& words = line.command.words;
  if (n_too_deep_ > 0) {
    --n_too_deep_;
  } else if (open_.size() == 1) {
    report(line.location, fmt::format("{} closes no block", shown("end", words)),
           "every block before is closed", length_of("end", words));
  } else if (!words.empty()) {
    close_titled(at, spelling(words));
  } else {
    // Indentation tells which block an END belongs to only where the count of ENDs is wrong anyway.
    const std::size_t block = is_balanced_ ? open_.size() - 1 : find_by_column(line.location.column);
    close_unfinished(block + 1, "it is missing before the END at " + to_string(line.location));
    close_innermost();
  }
}

void TreeBuilder::close_titled(std::size_t at, const Phrase& title) {
  DeckLine& line = lines_[at];
  const auto is_meant = [&](const Block& block) {
    return count_common(title, spelling(block.title)) == title.size();
  };
  const auto meant = std::find_if(open_.rbegin(), open_.rend() - 1, is_meant);
  if (meant != open_.rend() - 1) {
    const auto n_kept = static_cast<std::size_t>(open_.rend() - meant);
    close_unfinished(n_kept, fmt::format("it is missing before {} at {}", shown("end", line.command.words),
                                         to_string(line.location)));
    close_innermost();
  } else if (count_common(title, spelling(open_.back().title)) > 0) {
    open_.back().end = std::move(line.command.words);
    close_innermost();
  } else {
    close_mismatched(at, title);
  }
}

/// Closes the innermost block by an END that names another type, or drops the END when the block's own END is
/// still to come.
void TreeBuilder::close_mismatched(std::size_t at, const Phrase&) {
  const DeckLine& line = lines_[at];
  const Block& block = open_.back();
  report(line.location,
         fmt::format("{} does not close {}", shown("end", line.command.words), shown("begin", block.title)),
         "the block begins at " + to_string(block.location), length_of("end", line.command.words));
  if (!is_needed_later(at)) close_innermost();
}

/// Whether the next END on the innermost block's own level names that block.
bool TreeBuilder::is_needed_later(std::size_t at) const {
  const Phrase title = spelling(open_.back().title);
  std::size_t depth = 0;
  const std::size_t last = std::min(lines_.size(), at + 1 + max_lines_looked_ahead);
  for (std::size_t i = at + 1; i < last; ++i) {
    const DeckLine& line = lines_[i];
    if (line.kind == Kind::begin) {
      ++depth;
    } else if (line.kind == Kind::end && depth == 0) {
      return count_common(title, spelling(line.command.words)) > 0;
    } else if (line.kind == Kind::end) {
      --depth;
    }
  }
  return false;
}

/// The innermost open block whose BEGIN stands in the column, or the innermost of all.
std::size_t TreeBuilder::find_by_column(int column) const {
  for (std::size_t i = open_.size() - 1; i > 0; --i) {
    if (open_[i].location.column == column) return i;
  }
  return open_.size() - 1;
}

const DeckLocation& location_of(const Item& item) {
  const Block* block = std::get_if<Block>(&item.value);
  return block ? block->location : std::get<Command>(item.value).words.front().location;
}

/// The first item of a block without END that looks as if it stood behind the missing END: in an indented
/// block one that is not indented, or one that begins another block of the same type.
std::vector<Item>::iterator find_outer_item(Block& block) {
  const auto is_indented = [&](const Item& item) {
    const DeckLocation& place = location_of(item);
    return place.file != block.location.file || place.column > block.location.column;
  };
  const bool is_indenting = !block.items.empty() && is_indented(block.items.front());
  const Phrase title = spelling(block.title);
  return std::find_if(block.items.begin(), block.items.end(), [&](const Item& item) {
    const Block* inner = std::get_if<Block>(&item.value);
    const bool is_of_same_type = inner != nullptr && count_common(spelling(inner->title), title) > 0;
    return is_of_same_type || (is_indenting && !is_indented(item));
  });
}

/// Closes open blocks without END until `n_kept` are left, and moves what seems to follow the missing END
/// into the block around.
void TreeBuilder::close_unfinished(std::size_t n_kept, const std::string& hint) {
  while (open_.size() > n_kept) {
    Block block = std::move(open_.back());
    open_.pop_back();
    report(block.location, fmt::format("{} has no END", shown("begin", block.title)), hint,
           length_of("begin", block.title));
    block.is_closed = false;
    const auto outer = find_outer_item(block);
    std::vector<Item> moved(std::make_move_iterator(outer), std::make_move_iterator(block.items.end()));
    block.items.erase(outer, block.items.end());
    auto& items = open_.back().items;
    items.push_back({std::move(block)});
    std::move(moved.begin(), moved.end(), std::back_inserter(items));
  }
}

void TreeBuilder::close_innermost() {
  Block block = std::move(open_.back());
  open_.pop_back();
  open_.back().items.push_back({std::move(block)});
}

void TreeBuilder::report(const DeckLocation& location, std::string text, std::string hint, int length) {
  if (++n_errors_ < max_errors) {
    diagnostics_.add_error(location, std::move(text), std::move(hint), length);
  } else if (n_errors_ == max_errors) {
    diagnostics_.add_error(location, "too many BEGIN and END lines are wrong; further ones are not shown");
  }
}

}  // namespace

Block parse_syntax(const Source& source, Diagnostics& diagnostics, const FileReader& read_file) {
  return TreeBuilder(read_deck_lines(source, diagnostics, read_file), diagnostics).build();
}

void check_end(const Block& block, std::size_t n_type_words, Diagnostics& diagnostics) {
  if (block.end.empty()) return;
  const std::span<const Word> title = block.title;
  const Phrase end = spelling(block.end);
  const std::size_t n_common = count_common(end, spelling(title));
  if (n_common == end.size()) return;
  const std::size_t n_type = spelling(title.first(std::min(n_type_words, title.size()))).size();
  const DeckLocation& place = block.end.front().location;
  const int length = length_of("end", block.end) - 4;
  const std::string hint = "the block begins at " + to_string(block.location);
  if (n_common < n_type) {
    diagnostics.add_error(place,
                          fmt::format("{} does not close {}", shown("end", block.end), shown("begin", title)),
                          hint, length);
  } else {
    diagnostics.add_warning(
        "deck-end-name", place,
        fmt::format("{} has another name than {}", shown("end", block.end), shown("begin", title)), hint,
        length);
  }
}

}  // namespace contactsim
