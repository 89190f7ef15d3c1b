// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/output_place.hpp"

#include <filesystem>
#include <system_error>

namespace contactsim {

namespace fs = std::filesystem;

OutputPlace::OutputPlace(const std::string& path) : target_(path) {
  std::error_code error;
  const fs::path pointed_to =
      fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : fs::path(path);
  if (!error && !pointed_to.empty()) target_ = pointed_to.string();
  const bool is_other = fs::is_other(target_, error);
  unfinished_ = is_other ? target_ : target_ + ".part";
}

std::string OutputPlace::commit() const {
  if (!is_regular()) return "";
  std::error_code error;
  fs::rename(unfinished_, target_, error);
  if (!error) return "";
  discard();
  return error.message();
}

void OutputPlace::discard() const {
  if (!is_regular()) return;
  std::error_code ignored;
  fs::remove(unfinished_, ignored);
}

}  // namespace contactsim
