// SPDX-License-Identifier: BSD-3-Clause
// Random decks through the deck reader, in this process: see tests/campaigns/README.md.
#include <omp.h>

#include <fstream>
#include <iterator>

#include "campaigns/decks/deck_harm.hpp"
#include "campaigns/decks/deck_mutator.hpp"
#include "campaigns/support/campaign_cases.hpp"

namespace contactsim::test {

namespace {

class DeckCases : public CampaignCases {
 public:
  explicit DeckCases(const CampaignOptions& options)
      : seed_(options.seed), seeds_(read_deck_seeds(options.source)) {}

  std::string run(std::uint64_t number) override {
    return find_deck_harm(text_of(number), number % 16 == 0 ? DeckLook::all : DeckLook::some);
  }

  std::string replay(const std::filesystem::path& file) override {
    std::ifstream in(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    return find_deck_harm(text, DeckLook::all);
  }

  void keep(std::uint64_t number, const std::filesystem::path& folder) override {
    std::ofstream(folder / "deck.i", std::ios::binary) << text_of(number);
  }

 private:
  std::string text_of(std::uint64_t number) const {
    CaseRandom random("decks", seed_, number);
    return draw_deck(seeds_, random);
  }

  std::uint64_t seed_;
  DeckSeeds seeds_;
};

}  // namespace

}  // namespace contactsim::test

int main(int argc, char** argv) {
  using namespace contactsim::test;
  omp_set_num_threads(1);
  CaseLimits limits;
  limits.cases_per_process = 100000;
  return run_campaign_program<DeckCases>("decks", argc, argv, limits);
}
