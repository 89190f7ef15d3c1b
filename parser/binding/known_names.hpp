// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/base/names.hpp"

namespace contactsim {

/// The names of one kind that are known in one place of a deck, and what they stand for. Names are compared
/// without case.
class KnownNames {
 public:
  /// kind   as messages say it: "function"
  /// owner  what the definitions belong to, if not to the deck: "the material 'steel'"
  /// made_by  the line that makes a definition, told where there is none
  explicit KnownNames(std::string kind, std::string owner = "", std::string_view made_by = "")
      : kind_(std::move(kind)), owner_(std::move(owner)), made_by_(made_by) {}

  /// Adds a definition. A second one of the same name is an error there, and stands for the name as well. An
  /// empty name is passed over.
  ///   definition  the caller's number for it
  void define(const DeckName& name, std::size_t definition, Diagnostics& diagnostics);
  /// Adds a name that needs no definition. It is not offered as a suggestion.
  ///   may_be_defined  whether a definition may take its place
  void add_built_in(std::string_view name, bool may_be_defined = false);
  /// From now on a name that is not known counts as defined elsewhere.
  void allow_unknown() { allows_unknown_ = true; }

  /// The definitions that the name stands for, none of a built-in one. A name that is not known is an error
  /// at the reference, with the nearest known one.
  std::vector<std::size_t> look_up(const DeckName& reference, Diagnostics& diagnostics) const;

  bool knows(std::string_view name) const { return by_name_.count(fold(name)) > 0; }
  /// The same without a word about names that are not known.
  std::vector<std::size_t> find(std::string_view name) const;

 private:
  struct Entry {
    std::vector<std::size_t> definitions;
    DeckLocation location;        ///< of the first
    bool may_be_defined = false;  ///< of a built-in name
  };

  std::string name_for_message(const DeckName& name) const;

  std::string kind_, owner_, made_by_;
  std::vector<std::string> spellings_;  ///< in the order of definition
  std::unordered_map<std::string, Entry> by_name_;
  bool allows_unknown_ = false;
};

}  // namespace contactsim
