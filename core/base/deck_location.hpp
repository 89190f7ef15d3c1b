// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace contactsim {

/// One file of deck text as it was read; every location in it keeps it alive.
struct SourceFile {
  std::string name;  ///< as the user wrote it: the deck's path, or the path of an include command
  std::string text;  ///< the whole file, before Aprepro, line ends as read
};

/// How a piece of text came to stand where it does: the include or the loop around it, outwards.
struct Trail {
  std::string text;  ///< one line, such as "included from plate.i:12" or "loop 3 of 10 at plate.i:5"
  std::shared_ptr<const Trail> outer;
};

/// Where a character of the deck was written. A default-made location means "no deck line".
struct DeckLocation {
  std::shared_ptr<const SourceFile> file;
  int line = 0;    ///< from 1
  int column = 0;  ///< from 1, in bytes
  std::shared_ptr<const Trail> trail;

  bool is_known() const { return file != nullptr; }
};

/// "plate.i:12:25", or "" when the location is not known.
std::string to_string(const DeckLocation& location);

/// The deck line that holds the location, without its line end; "" when the location is not known.
std::string line_text(const DeckLocation& location);

}  // namespace contactsim
