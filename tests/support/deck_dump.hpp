// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/diagnostics.hpp"
#include "parser/text/ast.hpp"

namespace contactsim {

/// The words of a line, blank between them: quoted ones in "", symbols in [].
inline std::string dump(const std::vector<Word>& words) {
  std::string text;
  for (const Word& word : words) {
    if (!text.empty()) text += ' ';
    if (word.kind == WordKind::quoted) {
      text += '"' + word.text + '"';
    } else {
      text += word.kind == WordKind::symbol ? '[' + word.text + ']' : word.text;
    }
  }
  return text;
}

/// A block's items, one a line; inner blocks as "{title" ... "}".
inline std::string dump(const Block& block) {
  std::string text;
  for (const Item& item : block.items) {
    if (const Block* inner = std::get_if<Block>(&item.value)) {
      text += '{' + dump(inner->title) + '\n' + dump(*inner) + "}\n";
    } else {
      text += dump(std::get<Command>(item.value).words) + '\n';
    }
  }
  return text;
}

/// All diagnostics in machine form.
inline std::string messages(const Diagnostics& diagnostics) {
  std::string text;
  for (const DiagnosticGroup& group : diagnostics.grouped()) text += format_machine(group);
  return text;
}

}  // namespace contactsim
