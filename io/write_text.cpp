// SPDX-License-Identifier: BSD-3-Clause
#include "io/write_text.hpp"

#include <cstdio>
#include <fstream>

#include "core/errors.hpp"

namespace contactsim {

void write_text(const std::string& path, std::string_view text) {
  const std::string unfinished = path + ".part";
  std::ofstream file(unfinished, std::ios::binary);
  file << text;
  file.close();
  const bool is_whole = !file.fail() && std::rename(unfinished.c_str(), path.c_str()) == 0;
  if (is_whole) return;
  std::remove(unfinished.c_str());
  throw FileError(path, "the file cannot be written");
}

}  // namespace contactsim
