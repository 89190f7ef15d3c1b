// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// A file of the manual.
struct ManualFile {
  std::string path;  ///< below the folder that it is written to
  std::string text;
};

}  // namespace contactsim
