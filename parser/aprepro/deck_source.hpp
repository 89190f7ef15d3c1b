// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/base/diagnostics.hpp"
#include "parser/aprepro/aprepro.hpp"
#include "parser/text/source.hpp"

namespace contactsim {

/// Reads a deck file and expands it by Aprepro.
/// Throws FileError when the file cannot be opened, DeckError when it is no text, and when its expansion
/// would take too long; every other problem goes to `diagnostics`.
Source read_deck_source(const std::string& path, const ApreproOptions& options, Diagnostics& diagnostics);

}  // namespace contactsim
