// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "parser/command_tree.hpp"

namespace contactsim {

/// "sierra > function > x scale", for failures.
inline std::string path_of(const TreeRow& entry) {
  std::string path;
  for (const RowText* block : entry.around) path += block->phrase + " > ";
  return path + (entry.row->phrase.empty() ? entry.row->syntax : entry.row->phrase);
}

}  // namespace contactsim
