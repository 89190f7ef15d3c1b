// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/binding/known_names.hpp"
#include "parser/binding/name_kinds.hpp"

namespace contactsim {

/// A name of the deck and what it stands for.
struct NamedKind {
  NameKind kind;
  DeckName name;
};

/// What the line of a command says by names.
struct NameNotes {
  std::vector<NamedKind> defined, referred;
  std::vector<NameKind> left_open;  ///< kinds of which the mesh gives further names
};

/// The names of a deck: as its blocks are bound every definition and every reference is noted in the block
/// where it stands, and after that all are looked up at once, so that names may be used before they are
/// defined. What stands in a definition that nothing uses is not looked up (see Counts).
class DeckNames {
 public:
  DeckNames();

  /// What is noted up to end_block belongs to this block.
  ///   phrase  as the deck calls such a block: "spot weld"
  ///   kind    what its name defines, if anything
  void begin_block(std::string_view phrase, std::optional<NameKind> kind, const DeckName& name);
  void end_block() { current_ = blocks_[current_].around; }
  /// The current block counts as if it were not there.
  void drop_block() { blocks_[current_].is_dropped = true; }
  void note(std::string_view phrase, const NameNotes& notes);
  void refer(NameKind kind, const DeckName& name);

  /// Where problems in reading the lines of the current block go.
  ///   otherwise  where they go at once
  Diagnostics& problems_of_lines(Diagnostics& otherwise);
  /// What is wrong with the current block as a whole: counts as the names in it do.
  Diagnostics& problems_of_block() { return blocks_[current_].of_block; }
  /// Lines of the current block could not be read. That is the likely cause of its errors as a whole, which
  /// are forgotten when it has no blocks inside.
  void note_wrong_lines();
  /// Adds one of them under the block's name: "the spot weld 'w'" and `text`, which goes on "has no SURFACE".
  void add_problem_of_block(std::string_view text, std::string hint = "");
  /// The current block as messages call it: "the spot weld 'w'".
  std::string block_for_message() const;

  /// In a deck of contact alone all but what a contact definition holds may be defined elsewhere.
  void allow_unknown() { is_fragment_ = true; }
  /// Looks up the references, from the whole deck into what is used; names that are not known are errors.
  void resolve(Diagnostics& diagnostics);
  /// Looks up one more name, of a kind that is known in all of the deck. Precondition: resolve() was called.
  void use(NameKind kind, const DeckName& reference, Diagnostics& diagnostics);
  /// Uses all definitions of a kind. Precondition: resolve() was called.
  void use_all(NameKind kind, Diagnostics& diagnostics);
  /// Whether something uses a definition, which is known by its name and place.
  bool is_used(NameKind kind, const DeckName& definition) const;
  /// Whether lines of a definition could not be read: what it lacks may be what they were to give.
  bool has_wrong_lines(NameKind kind, const DeckName& definition) const;

  /// Problems of lines that waited for a use; of what nothing uses they are warnings ("deck-unused").
  void report_problems_of_lines(Diagnostics& diagnostics) const;

 private:
  struct NamedBlock {
    std::size_t around = 0;
    std::string_view phrase;
    std::optional<NameKind> kind;
    DeckName name;
    std::vector<NamedKind> references;
    std::vector<NameKind> left_open;
    std::vector<std::size_t> inner;
    Diagnostics of_lines, of_block;
    bool is_used = false, is_dropped = false, has_wrong_lines = false;
  };
  using Home = std::pair<std::size_t, NameKind>;  ///< a block, and what is known in it

  void define_all(Diagnostics& diagnostics);
  KnownNames& known_in(const Home& home);
  std::size_t home_around(NameKind kind, std::size_t block) const;
  const NamedBlock* find_block(NameKind kind, const DeckName& definition) const;
  std::vector<std::size_t> homes_of(const NamedKind& reference, std::size_t block, Diagnostics& diagnostics);
  void look_up(const NamedKind& reference, std::size_t block, Diagnostics& diagnostics);
  void mark_used(std::size_t block);
  void look_up_in_used(Diagnostics& diagnostics);

  std::deque<NamedBlock> blocks_;  ///< the first is the deck, around itself; a deque, so that they stay
  std::size_t current_ = 0;
  std::map<Home, KnownNames> known_;
  std::vector<std::size_t> new_in_use_;  ///< used blocks whose references are not looked up yet
  bool is_fragment_ = false;
};

}  // namespace contactsim
