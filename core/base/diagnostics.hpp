// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/deck_location.hpp"

namespace contactsim {

enum class Severity { warning, error };

/// One thing that is wrong, or that the user should decide about.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string id;         ///< stable name of a warning, such as "surface-empty"; errors may have one
  DeckLocation location;  ///< may be unknown, when no deck line is at fault
  int length = 1;         ///< characters to underline from the location on, at least 1
  std::string text;       ///< what is wrong and what was found, no final full stop
  std::string hint;  ///< what to do: the nearest legal word, the place of the other definition; may be ""
};

/// Equal diagnostics (severity, id, text) of several places, as they are shown.
struct DiagnosticGroup {
  Diagnostic first;
  std::vector<DeckLocation> others;  ///< the further places, in order
  std::size_t n_alike = 0;           ///< of its kind that follow and are only counted
  DeckLocation last_alike = {};      ///< of the last of them
};

/// Collects what a stage finds, so that all problems of a deck or mesh appear in one run.
class Diagnostics {
 public:
  void add_error(const DeckLocation& location, std::string text, std::string hint = "", int length = 1);
  void add_warning(std::string_view id, const DeckLocation& location, std::string text, std::string hint = "",
                   int length = 1);
  /// Control characters of text and hint become blanks, a length below 1 becomes 1.
  void add(Diagnostic diagnostic);
  void append(const Diagnostics& other);

  bool has_errors() const { return n_errors_ > 0; }
  std::size_t error_count() const { return n_errors_; }
  bool empty() const { return found_.empty(); }

  /// In the order in which they were found.
  const std::vector<Diagnostic>& all() const { return found_; }

  /// Sorted by file (in order of first appearance), line and column, equal ones joined; diagnostics without
  /// a location come last. Of errors in a row that differ in quoted words and numbers alone the first 20
  /// stand for the others.
  std::vector<DiagnosticGroup> grouped() const;

 private:
  std::vector<Diagnostic> found_;
  std::size_t n_errors_ = 0;
};

/// The machine form, one line per diagnostic: "plate.i:12:25: error: text; hint", trail lines after it.
/// A group names its first five places and counts the rest.
std::string format_machine(const DiagnosticGroup& group);

/// The machine form followed by the deck line and a caret under the word.
std::string format_with_caret(const DiagnosticGroup& group, bool colour);

}  // namespace contactsim
