// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

/// A pair as both tables know it: by the names of the second, in alphabetical order.
struct KnownPair {
  std::string first, second, interaction;
  auto operator<=>(const KnownPair&) const = default;
  std::string text() const { return fmt::format("{} - {} ({})", first, second, interaction); }
};

struct PairSettings {
  std::string first;  ///< the surface that stands first
  std::map<std::string, std::string> values;
};

using Pairs = std::map<KnownPair, PairSettings>;

/// The pairs of a table.
///   new_names  of its surfaces
Pairs known_pairs(const OwnershipTable& table, const NewNames& new_names) {
  Pairs pairs;
  for (const TablePair& pair : table.pairs) {
    const std::string first = renamed(pair.first, new_names), second = renamed(pair.second, new_names);
    PairSettings& known = pairs[{std::min(first, second), std::max(first, second), pair.interaction}];
    known.first = first;
    known.values.insert(pair.settings.begin(), pair.settings.end());
  }
  return pairs;
}

void add_settings(const std::string& name, PairSettings a, PairSettings b,
                  std::vector<Difference>& differences) {
  for (const auto& [key, value] : a.values) b.values.try_emplace(key, "absent");
  for (const auto& [key, value] : b.values) {
    const std::string& before = a.values.try_emplace(key, "absent").first->second;
    if (before == value) continue;
    differences.push_back({"pair",
                           fmt::format("pair {}: {} {} -> {}", name, key, before, value),
                           {{"pair", name}, {"setting", key}, {"first", before}, {"second", value}}});
  }
}

}  // namespace

const std::string& renamed(const std::string& name, const NewNames& new_names) {
  const auto found = new_names.find(name);
  return found == new_names.end() ? name : found->second;
}

void add_pairs(const OwnershipTable& first_table, const OwnershipTable& second_table,
               const NewNames& new_names, std::vector<Difference>& differences) {
  const Pairs first = known_pairs(first_table, new_names), second = known_pairs(second_table, {});
  const auto add_lone = [&](const char* kind, const char* where, const Pairs& one, const Pairs& other) {
    for (const auto& [pair, settings] : one) {
      if (other.contains(pair)) continue;
      differences.push_back(
          {kind, fmt::format("only in the {}: pair {}", where, pair.text()), {{"pair", pair.text()}}});
    }
  };
  add_lone("pair_only_in_first", "first", first, second);
  add_lone("pair_only_in_second", "second", second, first);
  std::int64_t n_turned = 0;
  for (const auto& [pair, settings] : first) {
    const auto found = second.find(pair);
    if (found == second.end()) continue;
    n_turned += settings.first != found->second.first ? 1 : 0;
    add_settings(pair.text(), settings, found->second, differences);
  }
  if (n_turned == 0) return;
  differences.push_back({"pair_sides",
                         fmt::format("first and second change places in {}",
                                     pluralize(static_cast<std::size_t>(n_turned), "pair")),
                         {{"pairs", n_turned}}});
}

}  // namespace contactsim
