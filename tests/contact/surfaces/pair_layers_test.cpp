// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/pair_layers.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::vector<DeckName> list(const std::string& letters) {
  std::vector<DeckName> names;
  for (const char letter : letters) names.push_back({std::string(1, letter), {}});
  return names;
}

ActivePeriods periods(const std::string& active, const std::string& inactive = "") {
  return {list(active), list(inactive)};
}

bool has(const std::vector<DeckName>& names, char letter) {
  return std::ranges::find(names, DeckName{std::string(1, letter), {}}) != names.end();
}

/// The letters of a to d in which the periods act.
std::string letters(const std::optional<ActivePeriods>& of) {
  std::string found;
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    if (of && (of->active.empty() || has(of->active, letter)) && !has(of->inactive, letter)) found += letter;
  }
  return found;
}

SurfacePair pair_of(const std::string& name, const ActivePeriods& of) {
  SurfacePair pair;
  pair.interaction = name;
  pair.periods = of;
  return pair;
}

}  // namespace

TEST_CASE("periods in common and the others are those of sets", "[contact][pairs]") {
  const std::vector<ActivePeriods> some{periods(""),         periods("a"),       periods("ab"),
                                        periods("", "a"),    periods("bc", "b"), periods("", "cd"),
                                        periods("abcd", "d")};
  for (const ActivePeriods& a : some) {
    const std::string of_a = letters(a);
    for (const char letter : {'a', 'b', 'c', 'd'})
      CHECK((letters(other_periods(a)).find(letter) == std::string::npos) ==
            (of_a.find(letter) != std::string::npos));
    for (const ActivePeriods& b : some) {
      std::string both;
      for (const char letter : letters(b)) {
        if (of_a.find(letter) != std::string::npos) both += letter;
      }
      CHECK(letters(common_periods(a, b)) == both);
    }
  }
  CHECK(!common_periods(periods("a"), periods("b")));
  CHECK(!other_periods(periods("")));
}

TEST_CASE("in every period the last layer that acts holds, unless excluded", "[contact][pairs]") {
  std::mt19937 random(5);
  const auto any = [&] {
    const std::vector<ActivePeriods> some{periods(""), periods("a"), periods("bd"), periods("", "ab"),
                                          periods("c")};
    return some[random() % some.size()];
  };
  for (int round = 0; round < 200; ++round) {
    PairLayers layers;
    std::vector<ActivePeriods> added, excluded;
    for (auto i = random() % 4 + 1; i > 0; --i) {
      added.push_back(any());
      layers.add(pair_of(std::to_string(added.size() - 1), added.back()), added.size() - 1);
    }
    for (auto i = random() % 3; i > 0; --i) {
      excluded.push_back(any());
      layers.exclude(excluded.back(), excluded.size() - 1);
    }
    const std::size_t n_idle = layers.overridden().size();
    const std::vector<SurfacePair> pairs = layers.take();
    CHECK(pairs.size() + n_idle == added.size());
    for (const char letter : {'a', 'b', 'c', 'd', 'z'}) {
      const auto acts = [&](const ActivePeriods& of) {
        return (of.active.empty() || has(of.active, letter)) && !has(of.inactive, letter);
      };
      std::string expected;
      for (std::size_t i = 0; i < added.size(); ++i) {
        if (acts(added[i])) expected = std::to_string(i);
      }
      if (std::ranges::any_of(excluded, acts)) expected.clear();
      std::string acting;
      for (const SurfacePair& pair : pairs) {
        if (acts(pair.periods)) acting += pair.interaction;
      }
      CHECK(acting == expected);
    }
  }
}

TEST_CASE("who takes an interaction's place is the next one in its periods, or the exclusion",
          "[contact][pairs]") {
  PairLayers layers;
  layers.add(pair_of("0", periods("a")), 0);
  layers.add(pair_of("1", periods("b")), 1);
  layers.add(pair_of("2", periods("", "b")), 2);
  layers.exclude(periods("b"), 7);
  const auto overridden = layers.overridden();
  REQUIRE(overridden.size() == 2);
  CHECK(overridden[0].interaction == 1);
  CHECK(overridden[0].by == 7);
  CHECK(overridden[0].is_by_exclusion);
  CHECK(overridden[1].interaction == 0);
  CHECK(overridden[1].by == 2);
  CHECK(!overridden[1].is_by_exclusion);
}
