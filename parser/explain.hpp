// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

namespace contactsim {

/// What `contactsim explain` prints.
struct Explanation {
  std::string text;
  bool is_found = true;  ///< whether any block or command is so called
};

/// The reference of the deck language, made from the rows that parse it, at most 100 columns wide (where its
/// words allow).
///   words  none: the tree of blocks, a line of help for each. Else a phrase or a part of one, in any case:
///          every block and command whose phrase holds it, with its place, syntax, help, default and support;
///          when there is none, the nearest phrases
Explanation explain(std::span<const std::string> words);

}  // namespace contactsim
