// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/block_rows.hpp"

#include <fmt/format.h>

namespace contactsim {

std::string syntax_of(Naming naming) {
  switch (naming) {
    case Naming::none:
      return "";
    case Naming::optional:
      return "[<name>]";
    case Naming::required:
      return "<name>";
  }
  return "";
}

void check_name(const Block& block, const DeckName& name, Naming naming) {
  const bool is_wrong = naming == Naming::required && name.text.empty();
  if (!is_wrong) return;
  const Word& last = block.title.back();
  throw ArgumentError{{Severity::error, "", last.location, static_cast<int>(last.text.size()),
                       fmt::format("the block '{}' needs a name", last.text), ""}};
}

}  // namespace contactsim
