// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/open_file_limit.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace contactsim {

void allow_open_files(std::size_t n) {
  constexpr rlim_t n_others = 128;  // standard streams, libraries, log, results
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const rlim_t wanted = static_cast<rlim_t>(n) + n_others;
  if (limit.rlim_cur >= wanted) return;
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? wanted : std::min(wanted, limit.rlim_max);
  setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace contactsim
