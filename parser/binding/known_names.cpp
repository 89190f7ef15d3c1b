// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/known_names.hpp"

#include <fmt/format.h>

namespace contactsim {

std::string KnownNames::name_for_message(const DeckName& name) const {
  const std::string owner_text = owner_.empty() ? "" : " of " + owner_;
  return fmt::format("{} '{}'{}", kind_, name.text, owner_text);
}

void KnownNames::define(const DeckName& name, std::size_t definition, Diagnostics& diagnostics) {
  if (name.text.empty()) return;
  const auto [entry, is_new] = by_name_.try_emplace(fold(name.text));
  Entry& known = entry->second;
  if (is_new || known.may_be_defined) {
    known = {{definition}, name.location};
    spellings_.push_back(name.text);
    return;
  }
  known.definitions.push_back(definition);
  const std::string first = to_string(known.location);
  diagnostics.add_error(name.location, fmt::format("the {} is defined a second time", name_for_message(name)),
                        first.empty() ? "the name is built in" : "the first stands at " + first,
                        static_cast<int>(name.text.size()));
}

void KnownNames::add_built_in(std::string_view name, bool may_be_defined) {
  by_name_.try_emplace(fold(name), Entry{{}, {}, may_be_defined});
}

std::vector<std::size_t> KnownNames::look_up(const DeckName& reference, Diagnostics& diagnostics) const {
  if (allows_unknown_ || knows(reference.text)) return find(reference.text);
  std::string hint = suggest(reference.text, spellings_);
  if (hint.empty() && spellings_.empty())
    hint = fmt::format("{} has no {}{}{}", owner_.empty() ? "the deck" : owner_, kind_,
                       made_by_.empty() ? "" : ": ", made_by_);
  constexpr std::size_t most_listed = 8;
  if (hint.empty() && !spellings_.empty() && spellings_.size() <= most_listed)
    hint = fmt::format("{} has {}", owner_.empty() ? "the deck" : owner_, fmt::join(spellings_, ", "));
  diagnostics.add_error(reference.location, "unknown " + name_for_message(reference), std::move(hint),
                        static_cast<int>(reference.text.size()));
  return {};
}

std::vector<std::size_t> KnownNames::find(std::string_view name) const {
  const auto entry = by_name_.find(fold(name));
  return entry == by_name_.end() ? std::vector<std::size_t>{} : entry->second.definitions;
}

}  // namespace contactsim
