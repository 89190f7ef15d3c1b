// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/base/names.hpp"

namespace contactsim {

/// The definition of a name that the deck uses. Null when there is none, which is an error that offers the
/// nearest of those there are.
///   kind  what the name is one of: "point"
template <class T>
const T* find_definition(const std::vector<T>& list, const DeckName& name, std::string_view kind,
                         Diagnostics& diagnostics) {
  const T* found = find_by_name(list, name.text);
  if (found != nullptr) return found;
  std::vector<std::string> known;
  for (const T& item : list) known.push_back(item.name.text);
  diagnostics.add_error(name.location, fmt::format("there is no {} '{}'", kind, name.text),
                        suggest(name.text, known), static_cast<int>(name.text.size()));
  return nullptr;
}

}  // namespace contactsim
