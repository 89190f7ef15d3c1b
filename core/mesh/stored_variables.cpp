// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/stored_variables.hpp"

#include <algorithm>
#include <span>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

std::optional<std::size_t> find_exact(const StoredVariableKind& kind, const std::string& folded) {
  for (std::size_t i = 0; i < kind.names.size(); ++i) {
    if (fold(kind.names[i]) == folded) return i;
  }
  return std::nullopt;
}

std::span<const std::string_view> suffixes(std::size_t n_components) {
  static constexpr std::string_view vector[] = {"x", "y", "z"};
  static constexpr std::string_view tensor[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  if (n_components == 3) return vector;
  if (n_components == 6) return tensor;
  return {};
}

}  // namespace

StoredTime find_stored_time(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return {0, 0, 0.0};
  const auto second = static_cast<std::size_t>(after - times.begin());
  if (after == times.end()) return {second - 1, second - 1, 0.0};
  return {second - 1, second, (time - times[second - 1]) / (times[second] - times[second - 1])};
}

std::optional<std::vector<std::size_t>> find_stored(const StoredVariableKind& kind, std::string_view name,
                                                    std::size_t n_components) {
  const std::string folded = fold(name);
  if (n_components == 1) {
    const auto found = find_exact(kind, folded);
    return found ? std::optional(std::vector{*found}) : std::nullopt;
  }
  std::vector<std::size_t> found;
  for (const std::string_view suffix : suffixes(n_components)) {
    auto component = find_exact(kind, folded + "_" + std::string(suffix));
    if (!component) component = find_exact(kind, folded + std::string(suffix));
    if (!component) return std::nullopt;
    found.push_back(*component);
  }
  return found;
}

}  // namespace contactsim
