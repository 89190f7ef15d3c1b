// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/end_at_once.hpp"

#include <sys/uio.h>
#include <unistd.h>

#include <array>

namespace contactsim {

void end_at_once(ExitCode code, std::initializer_list<std::string_view> parts) {
  // One call to the system, so that lines of other processes do not come between the parts.
  std::array<iovec, 16> pieces;
  std::size_t n_pieces = 0;
  const auto add = [&](std::string_view text) {
    pieces[n_pieces++] = {const_cast<char*>(text.data()), text.size()};
  };
  for (const std::string_view part : parts)
    if (n_pieces + 1 < pieces.size()) add(part);
  add("\n");
  [[maybe_unused]] const ssize_t n_written = writev(STDERR_FILENO, pieces.data(), static_cast<int>(n_pieces));
  _exit(static_cast<int>(code));
}

}  // namespace contactsim
