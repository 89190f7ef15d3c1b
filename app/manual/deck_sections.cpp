// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/deck_sections.hpp"

#include <algorithm>

namespace contactsim {

std::vector<DeckSection> deck_sections() {
  std::vector<DeckSection> sections;
  for (const TreeRow& entry : command_tree()) {
    auto section = std::find_if(sections.begin(), sections.end(),
                                [&](const DeckSection& s) { return s.around == entry.around; });
    if (section == sections.end()) section = sections.insert(sections.end(), {entry.around, {}});
    section->rows.push_back(&entry);
  }
  return sections;
}

}  // namespace contactsim
