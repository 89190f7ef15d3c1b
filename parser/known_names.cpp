// SPDX-License-Identifier: BSD-3-Clause
#include "parser/known_names.hpp"

#include <fmt/format.h>

namespace contactsim {

void KnownNames::define(const DeckName& name, Diagnostics& diagnostics) {
  if (name.text.empty()) return;
  const auto [entry, is_new] = by_name_.try_emplace(fold(name.text), Entry{name.location});
  if (is_new) {
    spellings_.push_back(name.text);
    return;
  }
  const std::string first = to_string(entry->second.location);
  diagnostics.add_error(name.location, fmt::format("the {} '{}' is defined a second time", kind_, name.text),
                        first.empty() ? "the name is built in" : "the first stands at " + first,
                        static_cast<int>(name.text.size()));
}

bool KnownNames::use(const DeckName& reference, Diagnostics& diagnostics) {
  const auto entry = by_name_.find(fold(reference.text));
  if (entry != by_name_.end()) {
    entry->second.is_used = true;
    return true;
  }
  if (allows_unknown_) return false;
  std::string hint = suggest(reference.text, spellings_);
  if (hint.empty() && spellings_.empty()) hint = fmt::format("the deck defines no {}", kind_);
  diagnostics.add_error(reference.location, fmt::format("unknown {} '{}'", kind_, reference.text),
                        std::move(hint), static_cast<int>(reference.text.size()));
  return false;
}

bool KnownNames::is_used(std::string_view name) const {
  const auto entry = by_name_.find(fold(name));
  return entry != by_name_.end() && entry->second.is_used;
}

}  // namespace contactsim
