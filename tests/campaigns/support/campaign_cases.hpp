// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "campaigns/support/campaign_options.hpp"

namespace contactsim::test {

/// What a campaign runs.
class CampaignCases {
 public:
  virtual ~CampaignCases() = default;
  /// Runs a case: what did harm, "" when nothing did. What it throws did harm.
  virtual std::string run(std::uint64_t number) = 0;
  /// The same of a file that was kept.
  virtual std::string replay(const std::filesystem::path& file) = 0;
  /// Writes the input of a case into a folder.
  virtual void keep(std::uint64_t number, const std::filesystem::path& folder) = 0;
};

/// What a case may take.
struct CaseLimits {
  double seconds = 2.0;                 ///< of the processor [s]
  double seconds_sanitized = 20.0;      ///< the same under sanitizers [s]
  std::uint64_t bytes = 1u << 30;       ///< of memory, beyond what stands before the first case
  std::uint64_t cases_per_process = 1;  ///< after which leaks are looked for, under sanitizers
};

/// Runs cases until the time or the count is over, in child processes: one that ends before its time is a
/// finding, and the next goes on behind its case. Prints findings and the line that counts.
/// Returns the exit code: 1 with findings.
int run_campaign(const CampaignOptions& options, const CaseLimits& limits, CampaignCases& cases);

/// The whole of a campaign's program: `Cases` are made of its options. Returns 2 when that cannot be done.
template <class Cases>
int run_campaign_program(const std::string& name, int argc, const char* const* argv,
                         const CaseLimits& limits) {
  try {
    const CampaignOptions options = read_campaign_options(name, argc, argv);
    Cases cases(options);
    return run_campaign(options, limits, cases);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "campaign %s: %s\n", name.c_str(), error.what());
    return 2;
  }
}

}  // namespace contactsim::test
