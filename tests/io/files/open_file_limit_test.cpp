// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/open_file_limit.hpp"

#include <sys/resource.h>

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("more files may be opened as far as the system allows", "[io][files]") {
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_NOFILE, &before) == 0);
  rlimit low = before;
  low.rlim_cur = 200;
  REQUIRE(setrlimit(RLIMIT_NOFILE, &low) == 0);
  rlimit now{};
  allow_open_files(10);
  getrlimit(RLIMIT_NOFILE, &now);
  CHECK(now.rlim_cur == 200);
  allow_open_files(300);
  getrlimit(RLIMIT_NOFILE, &now);
  CHECK(now.rlim_cur == std::min<rlim_t>(428, before.rlim_max));
  allow_open_files(std::size_t{1} << 40);
  getrlimit(RLIMIT_NOFILE, &now);
  CHECK(now.rlim_cur <= before.rlim_max);
  setrlimit(RLIMIT_NOFILE, &before);
}
