// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/output_place.hpp"

#include <filesystem>
#include <system_error>

#include "core/base/same_file.hpp"

namespace contactsim {

namespace fs = std::filesystem;

OutputPlace::OutputPlace(const std::string& path) : target_(link_target(path)) {
  std::error_code ignored;
  unfinished_ = fs::is_other(target_, ignored) ? target_ : unfinished_name(target_);
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
