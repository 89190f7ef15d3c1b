// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/end_at_once.hpp"

#include <unistd.h>

namespace contactsim {

void end_at_once(ExitCode code, std::initializer_list<std::string_view> parts) {
  const auto say = [](std::string_view text) {
    [[maybe_unused]] const ssize_t n_written = write(STDERR_FILENO, text.data(), text.size());
  };
  for (const std::string_view part : parts) say(part);
  say("\n");
  _exit(static_cast<int>(code));
}

}  // namespace contactsim
