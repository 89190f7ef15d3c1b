// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace contactsim::test {

/// What a child tells its parent, in memory of both.
struct Progress {
  std::atomic<std::uint64_t> next = 0;  ///< the case that runs or comes next
  std::atomic<std::uint64_t> n_done = 0;
  std::atomic<std::uint64_t> n_findings = 0;
  std::atomic<bool> is_in_case = false;
  std::atomic<bool> is_stopped = false;  ///< by SIGINT or SIGTERM
};

/// One that children share, until the end of the program. From then on SIGINT and SIGTERM stop the campaign.
Progress* make_shared_progress();

/// The most memory that this process has had.
std::uint64_t peak_bytes();

/// What has been thrown. To be called where it is caught.
std::string describe_exception();

}  // namespace contactsim::test
