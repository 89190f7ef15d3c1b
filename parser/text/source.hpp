// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/deck_location.hpp"

namespace contactsim {

/// A file of deck text with the offsets at which its lines begin.
struct IndexedFile {
  explicit IndexedFile(SourceFile read_file);
  SourceFile file;
  std::vector<std::size_t> line_starts;  ///< ascending, the first is 0
};

/// A character of a deck file, and the includes and loops that led to it.
struct Origin {
  std::shared_ptr<const IndexedFile> file;
  std::size_t offset = 0;  ///< into the file's text
  std::shared_ptr<const Trail> trail;
};

/// The deck location of an origin.
DeckLocation to_location(const Origin& origin);

/// Deck text that knows where each of its characters was written, through Aprepro, includes and loops.
/// Origins are kept per run of characters, so a text without preprocessing has a single run.
class Source {
 public:
  const std::string& text() const { return text_; }

  /// Where the character at `offset` was written. An offset at or past the end gives the place behind the
  /// last character; an empty source gives an unknown location. Takes O(log n).
  DeckLocation locate(std::size_t offset) const { return to_location(origin(offset)); }

  /// As locate(), but without looking up line and column.
  Origin origin(std::size_t offset) const;

  /// Appends text copied character by character from the file, `first` being the origin of its first one.
  void append_copied(std::string_view text, const Origin& first);

  /// Appends text that was made at one place, such as the value of an expression.
  void append_made(std::string_view text, const Origin& at);

  /// Appends the characters [begin, end) of another source with their origins; a trail that is not
  /// null replaces theirs.
  void append_part(const Source& from, std::size_t begin, std::size_t end,
                   const std::shared_ptr<const Trail>& trail);

 private:
  struct Run {
    std::size_t begin = 0;  ///< into text_
    Origin origin;          ///< of the run's first character
    bool is_made = false;   ///< every character has the run's origin
  };
  std::size_t run_at(std::size_t offset) const;

  std::string text_;
  std::vector<Run> runs_;
};

/// The source of a text that needs no preprocessing. A UTF-8 byte order mark at its start is dropped.
///   name   the file's name for messages
///   trail  how the text came to be read, null for the deck itself
Source make_source(std::string name, std::string text, const std::shared_ptr<const Trail>& trail = nullptr);

}  // namespace contactsim
