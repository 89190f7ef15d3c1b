// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "parser/command_tree.hpp"

namespace contactsim {

/// What the reference says of a row, in words: `contactsim explain` and the manual print it.
struct RowReference {
  std::string form;                    ///< as a deck would have it, "BEGIN FUNCTION <name>"
  std::string help;                    ///< as a sentence begins
  std::vector<std::string> spellings;  ///< further phrases that are read
  std::vector<std::string> names;      ///< what names in the line stand for, "a function"
  std::string dimension;               ///< "length/time", "" for none
  std::string default_text;            ///< "" for blocks that need not be there
  std::string choice;                  ///< "one of A, B or C", "" where the row is no part of a choice
  std::string support;                 ///< "supported", or what happens in its place
};

RowReference reference_of(const TreeRow& entry);

/// A row's help as a sentence begins; as a hint of a message it may begin in lower case.
std::string help_of(const RowText& row);

/// The blocks around a row, "sierra > presto procedure", "the deck's top level" for none.
std::string place_of(const TreeRow& entry);

}  // namespace contactsim
