// SPDX-License-Identifier: BSD-3-Clause
#include "parser/aprepro/deck_source.hpp"

#include <utility>

#include "core/base/errors.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

Source read_deck_source(const std::string& path, const ApreproOptions& options, Diagnostics& diagnostics) {
  TextFile file = read_text_file(path);
  if (file.failure == TextFile::Failure::not_text) {
    diagnostics.add_error({}, path + " is no deck: " + file.problem);
    throw DeckError(diagnostics);
  }
  if (file.failure != TextFile::Failure::none) throw FileError(path, file.problem);
  const Source deck = make_source(path, std::move(file.text));
  return run_aprepro(deck, options, diagnostics);
}

}  // namespace contactsim
