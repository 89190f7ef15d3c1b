// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/base/names.hpp"

namespace contactsim {

/// A name at a line of "a.i", column 5.
inline DeckName name_at(const std::string& text, int line) {
  static const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", "\n\n\n\n\n\n\n\n"});
  return {text, {file, line, 5, nullptr}};
}

}  // namespace contactsim
