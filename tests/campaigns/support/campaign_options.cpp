// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/support/campaign_options.hpp"

#include <cstdlib>
#include <stdexcept>

namespace contactsim::test {

namespace {

double whole_seconds() {
  const char* set = std::getenv("CONTACTSIM_CAMPAIGN_SECONDS");
  return set == nullptr ? 60.0 : std::stod(set);
}

/// Sets what an option of the command line stands for.
void set_option(CampaignOptions& options, const std::string& word, const std::string& value) {
  if (word == "--share") {
    options.seconds = whole_seconds() * std::stod(value);
  } else if (word == "--count") {
    options.count = std::stoull(value);
  } else if (word == "--seed") {
    options.seed = std::stoull(value);
  } else if (word == "--first") {
    options.first = std::stoull(value);
  } else if (word == "--keep") {
    options.keep = value;
  } else if (word == "--replay") {
    options.replayed.emplace_back(value);
  } else if (word != "--seconds") {
    throw std::invalid_argument("unknown option " + word);
  }
}

}  // namespace

CampaignOptions read_campaign_options(const std::string& name, int argc, const char* const* argv) {
  CampaignOptions options;
  options.name = name;
  options.keep = "campaign_" + name;
  options.seconds = whole_seconds();
  std::optional<double> seconds;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--write") {
      options.is_to_write = true;
    } else if (!word.starts_with("--")) {
      options.source = word;
    } else if (++i == argc) {
      throw std::invalid_argument(word + " lacks its value");
    } else {
      set_option(options, word, argv[i]);
      if (word == "--seconds") seconds = std::stod(argv[i]);
    }
  }
  if (options.source.empty()) throw std::invalid_argument("the folder of the repository is missing");
  options.seconds = seconds.value_or(options.seconds);
  return options;
}

}  // namespace contactsim::test
