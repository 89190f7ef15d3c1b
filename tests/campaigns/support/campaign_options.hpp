// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace contactsim::test {

/// The command line of a campaign; its words mean what they mean in campaign.py.
struct CampaignOptions {
  std::string name;
  std::filesystem::path source;        ///< the repository, for decks and meshes
  double seconds = 60.0;               ///< --seconds, or --share of CONTACTSIM_CAMPAIGN_SECONDS [s]
  std::optional<std::uint64_t> count;  ///< --count: number of cases, however long they take
  std::uint64_t seed = 1;
  std::uint64_t first = 0;                      ///< number of the first case
  std::filesystem::path keep;                   ///< folder of the findings
  bool is_to_write = false;                     ///< --write: inputs are kept, not run
  std::vector<std::filesystem::path> replayed;  ///< --replay: files in place of cases
};

/// Throws std::invalid_argument that says what is wrong.
CampaignOptions read_campaign_options(const std::string& name, int argc, const char* const* argv);

}  // namespace contactsim::test
