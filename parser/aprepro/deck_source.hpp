// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "core/base/diagnostics.hpp"
#include "parser/text/source.hpp"

namespace contactsim {

/// Reads a deck file and expands it by Aprepro.
///   overrides  Aprepro variables set on the command line, "name=value" each
/// Throws FileError when the file cannot be opened, DeckError when it is no text, and when its expansion
/// would take too long; every other problem goes to `diagnostics`.
Source read_deck_source(const std::string& path, std::span<const std::string> overrides,
                        Diagnostics& diagnostics);

}  // namespace contactsim
