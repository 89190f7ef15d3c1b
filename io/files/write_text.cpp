// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/write_text.hpp"

#include <fstream>

#include "core/base/errors.hpp"
#include "io/files/output_place.hpp"

namespace contactsim {

void write_text(const std::string& path, std::string_view text) {
  const OutputPlace place(path);
  std::ofstream file(place.unfinished(), std::ios::binary);
  file << text;
  file.close();
  const bool is_whole = !file.fail();
  if (!is_whole) place.discard();
  if (!is_whole || !place.commit().empty()) throw FileError(path, "the file cannot be written");
}

}  // namespace contactsim
