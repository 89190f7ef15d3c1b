// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/base/names.hpp"

namespace contactsim {

/// The names of one kind that a deck defines, and which of them something uses. Names are compared without
/// case.
class KnownNames {
 public:
  /// kind   as messages say it: "function"
  /// owner  what the definitions belong to, if not to the deck: "the material 'steel'"
  explicit KnownNames(std::string kind, std::string owner = "")
      : kind_(std::move(kind)), owner_(std::move(owner)) {}

  /// Adds a definition. A second one of the same name is an error there. An empty name is passed over.
  void define(const DeckName& name, Diagnostics& diagnostics);
  /// Adds a name that needs no definition. It is not offered as a suggestion.
  void add_built_in(std::string_view name) { by_name_.try_emplace(fold(name)); }
  /// From now on a name that is not known counts as defined elsewhere.
  void allow_unknown() { allows_unknown_ = true; }

  /// Marks the name as used; a name that is not known is an error at the reference, with the nearest known
  /// one. Returns whether it is known.
  bool use(const DeckName& reference, Diagnostics& diagnostics);

  bool knows(std::string_view name) const { return by_name_.count(fold(name)) > 0; }
  bool is_used(std::string_view name) const;

 private:
  struct Entry {
    DeckLocation location;
    bool is_used = false;
  };

  std::string name_for_message(const DeckName& name) const;

  std::string kind_, owner_;
  std::vector<std::string> spellings_;  ///< in the order of definition
  std::unordered_map<std::string, Entry> by_name_;
  bool allows_unknown_ = false;
};

}  // namespace contactsim
