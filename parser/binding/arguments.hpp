// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/base/names.hpp"
#include "parser/binding/deck_names.hpp"
#include "parser/text/ast.hpp"
#include "parser/text/value_grammar.hpp"

namespace contactsim {

/// Thrown by Arguments when a word is not what the command takes; the binder turns it into a diagnostic
/// and goes on with the next line.
struct ArgumentError {
  Diagnostic diagnostic;
  bool is_refusal = false;  ///< understood, but not supported: a warning with --lenient
};

/// Reads the words of a command after its keyword phrase, left to right, by the rules of
/// text/value_grammar.hpp. Every reading function throws ArgumentError with the place, what was expected and
/// what was found.
class Arguments {
 public:
  /// Skips one separator (= IS ARE) at the front. `words` must outlive the object, `command` too.
  ///   what  the command as the user knows it, for messages: "friction coefficient"
  Arguments(std::string what, Words words, const Command& command, const DeckLocation& location);

  const std::string& what() const { return what_; }
  const DeckLocation& location() const { return location_; }  ///< of the command's first word
  bool at_end() const { return words_.empty(); }
  /// The next word without reading it. Precondition: !at_end().
  const Word& peek() const { return words_.front(); }

  /// The next word, whatever it is. `expected` completes "expected ..." when the line ends too early.
  const Word& word(std::string_view expected);
  double real();          ///< any finite number; Fortran's 1.0d0 too
  double positive();      ///< > 0
  double non_negative();  ///< >= 0
  std::int64_t integer();
  std::int64_t positive_integer();       ///< >= 1
  std::int64_t non_negative_integer();   ///< >= 0
  bool on_off();                         ///< ON TRUE YES / OFF FALSE NO
  DeckName name();                       ///< bare or quoted word
  std::string text();                    ///< one bare or quoted word, such as a file name
  std::string rest();                    ///< the rest of the line as it was written, both ends trimmed
  std::string all();                     ///< the same from the end of the phrase on, a separator word too
  Eigen::Vector3d vector();              ///< three numbers
  std::vector<DeckName> names();         ///< all remaining words, at least one
  std::vector<double> reals();           ///< all remaining words, at least one
  std::vector<std::int64_t> integers();  ///< all remaining words, at least one

  /// A name() that stands for something that is defined elsewhere, or in the mesh.
  DeckName reference(NameKind kind);
  /// All remaining words, at least one; `word` among them stands for nothing that is defined.
  std::vector<DeckName> references(NameKind kind, std::string_view word = "");
  DeckName definition(NameKind kind);  ///< a name() that this line defines
  /// Says what a name stands for that has been read.
  void refer(NameKind kind, DeckName name) { notes_.referred.push_back({kind, std::move(name)}); }
  void define(NameKind kind, DeckName name) { notes_.defined.push_back({kind, std::move(name)}); }
  /// Says that the mesh gives further names of the kind, here and in the block around.
  void leave_open(NameKind kind) { notes_.left_open.push_back(kind); }
  const NameNotes& notes() const { return notes_; }

  bool is_next(std::string_view keyword) const;  ///< case-blind, '_' as blank is not expanded
  bool accept(std::string_view keyword);         ///< reads the word if it is the keyword
  void expect(std::string_view keyword);
  void skip_separator();  ///< reads one of = IS ARE if it is next
  /// The position in `choices` of the next words; the longest that fits wins.
  std::size_t choice(const Choices& choices);
  /// Ends the reading; a word left over is an error.
  void expect_end();

  /// Notes something that the user should know and goes on; dropped when the line turns out to be wrong.
  void warn(std::string_view id, const Word& at, std::string text, std::string hint = "");
  const std::vector<Diagnostic>& warnings() const { return warnings_; }

  /// For a value that is understood and would change the answer, but is not supported.
  [[noreturn]] void refuse(const Word& at, std::string text, std::string hint = "") const;
  [[noreturn]] void fail(const Word& at, std::string text, std::string hint = "") const;
  [[noreturn]] void fail_here(std::string text,
                              std::string hint = "") const;  ///< at the next word or the line's end

 private:
  /// What the rule takes from the front of the words. What does not fit it is an error; `relation` stands
  /// between what was expected and the command.
  template <class V>
  V read(V (*take)(Words&), std::string_view relation = "for");
  /// Fails unless `holds`, as the command's value must.
  void require(bool holds, const Word& at, std::string_view must) const;

  std::string what_;
  Words line_;   ///< all words behind the phrase
  Words words_;  ///< those that are not read yet
  const Command* command_;
  DeckLocation location_;
  std::vector<Diagnostic> warnings_;
  NameNotes notes_;
};

}  // namespace contactsim
