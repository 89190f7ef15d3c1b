// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/known_names.hpp"

#include <fmt/format.h>

namespace contactsim {

std::string KnownNames::name_for_message(const DeckName& name) const {
  const std::string owner_text = owner_.empty() ? "" : " of " + owner_;
  return fmt::format("{} '{}'{}", kind_, name.text, owner_text);
}

void KnownNames::define(const DeckName& name, Diagnostics& diagnostics) {
  if (name.text.empty()) return;
  const auto [entry, is_new] = by_name_.try_emplace(fold(name.text), Entry{name.location});
  if (is_new) {
    spellings_.push_back(name.text);
    return;
  }
  const std::string first = to_string(entry->second.location);
  diagnostics.add_error(name.location, fmt::format("the {} is defined a second time", name_for_message(name)),
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
  if (hint.empty() && spellings_.empty())
    hint = fmt::format("{} has no {}", owner_.empty() ? "the deck" : owner_, kind_);
  diagnostics.add_error(reference.location, "unknown " + name_for_message(reference), std::move(hint),
                        static_cast<int>(reference.text.size()));
  return false;
}

bool KnownNames::is_used(std::string_view name) const {
  const auto entry = by_name_.find(fold(name));
  return entry != by_name_.end() && entry->second.is_used;
}

}  // namespace contactsim
