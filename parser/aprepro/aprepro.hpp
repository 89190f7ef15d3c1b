// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/base/diagnostics.hpp"
#include "parser/text/source.hpp"
#include "parser/text/text_file.hpp"

namespace contactsim {

/// What Aprepro is given besides the deck.
struct ApreproOptions {
  /// Variables set from outside, "name=value" each; a value that is no number is a string. They hold before
  /// the deck is read and are immutable: an assignment in the deck is passed over with the warning
  /// "aprepro-override". One that stands nowhere in the deck is an error, and one that it does not come to
  /// is warned about ("aprepro-unused").
  std::span<const std::string> overrides = {};
  FileReader read_file = read_text_file;        ///< for include, cinclude and file_to_string
  std::size_t max_work = std::size_t{1} << 28;  ///< characters handled before giving up, about three seconds
  bool is_lenient = false;  ///< undefined and unused variables are warnings ("aprepro-undefined" takes 0)
};

/// Expands a deck: text outside braces is copied, {expr} is replaced by its value, control lines act. The
/// whole text is handled, comments and quotes too. Copied characters keep their origins, a value has that of
/// its opening brace; includes and loop passes appear in the trails. A deck without braces comes through as
/// it is. All problems are reported; the value of a wrong expression is 1. Throws DeckError, with all that is
/// in `diagnostics`, when the expansion would take too long or too much memory, or at the 200th problem.
///
/// Not supported and reported as errors: arrays, units, Exodus queries, execute, rescan, output.
/// rand() begins from the same seed on every run. tolower() and toupper() leave their argument alone.
/// Source: SEACAS Aprepro documentation.
Source run_aprepro(const Source& deck, const ApreproOptions& options, Diagnostics& diagnostics);

}  // namespace contactsim
