// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/definition/declarations.hpp"

namespace contactsim {

/// What the variables of results are to contactsim: a deck may have them written under names of its own.
class StoredNames {
 public:
  /// Names of files are those of contactsim.
  StoredNames() = default;
  /// Of the results outputs of a region.
  explicit StoredNames(const Region& region);

  /// The name of contactsim for one on a file, without components; itself when the deck does not rename it.
  std::string variable_of(const std::string& on_file) const;
  /// What a variable may be called on a file: names of the deck, then its own.
  std::vector<std::string> on_file(std::string_view variable) const;

 private:
  std::map<std::string, std::string> variables_;  // by the folded name on the file
};

}  // namespace contactsim
