// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/describe_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>

namespace contactsim {

namespace {

constexpr std::size_t longest_list = 6;  // of names that are listed as they are
constexpr std::size_t max_moves = 10;    // that are listed one by one

/// One order and the places of its things in another, between the first and the last thing that moves.
class Reordering {
 public:
  Reordering(const std::vector<std::string>& names, const std::vector<std::size_t>& places)
      : names_(names), places_(places) {
    while (begin_ < end_ && places[begin_] == begin_) ++begin_;
    while (end_ > begin_ && places[end_ - 1] == end_ - 1) --end_;
  }

  std::string describe() const {
    if (names_.size() <= longest_list) return list_both();
    for (const auto& found : {find_exchange(), find_shift(), find_reversal()}) {
      if (found) return *found;
    }
    return list_moves();
  }

 private:
  std::string list_both() const {
    std::vector<std::string> after(names_.size());
    for (std::size_t i = 0; i < names_.size(); ++i) after[places_[i]] = names_[i];
    return fmt::format("{} -> {}", fmt::join(names_, ", "), fmt::join(after, ", "));
  }

  std::optional<std::string> find_exchange() const {
    if (places_[begin_] != end_ - 1 || places_[end_ - 1] != begin_) return std::nullopt;
    for (std::size_t i = begin_ + 1; i + 1 < end_; ++i) {
      if (places_[i] != i) return std::nullopt;
    }
    return fmt::format("'{}' and '{}', {} and {} of {}, change places", names_[begin_], names_[end_ - 1],
                       begin_ + 1, end_, names_.size());
  }

  /// Neighbours that go past the rest of what moves, which keeps its order.
  std::optional<std::string> find_shift() const {
    const std::size_t n = end_ - begin_, first = places_[begin_] - begin_;
    for (std::size_t i = 0; i < n; ++i) {
      if (places_[begin_ + i] != begin_ + (first + i) % n) return std::nullopt;
    }
    // Either the last `first` go to the front or the others to the end: the fewer are listed.
    return 2 * first <= n ? tell_shift(end_ - first, first) : tell_shift(begin_, n - first);
  }

  std::string tell_shift(std::size_t at, std::size_t n) const {
    const std::size_t to = places_[at];
    if (n == 1)
      return fmt::format("'{}' goes from place {} to {} of {}", names_[at], at + 1, to + 1, names_.size());
    return fmt::format("'{}' to '{}', {} surfaces, go from place {} to {} of {}", names_[at],
                       names_[at + n - 1], n, at + 1, to + 1, names_.size());
  }

  std::optional<std::string> find_reversal() const {
    for (std::size_t i = begin_; i < end_; ++i) {
      if (places_[i] != begin_ + end_ - 1 - i) return std::nullopt;
    }
    return fmt::format("'{}' to '{}', {} to {} of {}, stand the other way round", names_[begin_],
                       names_[end_ - 1], begin_ + 1, end_, names_.size());
  }

  /// All but the most that keep their order among themselves.
  std::string list_moves() const {
    const std::vector<bool> stays = find_longest_rise();
    std::string text;
    std::size_t n_moved = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (stays[i] || ++n_moved > max_moves) continue;
      text += fmt::format("{}'{}' {} -> {}", text.empty() ? "" : ", ", names_[i], i + 1, places_[i] + 1);
    }
    if (n_moved > max_moves) text += fmt::format(" and {} more", n_moved - max_moves);
    return fmt::format("{} of {} go elsewhere: {}", n_moved, names_.size(), text);
  }

  /// Which things are in a longest part whose places rise.
  std::vector<bool> find_longest_rise() const {
    const std::size_t n = places_.size();
    std::vector<std::size_t> tails;  // positions of the ends of rises, by their length
    std::vector<std::optional<std::size_t>> before(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto at =
          std::ranges::lower_bound(tails, places_[i], {}, [&](std::size_t k) { return places_[k]; });
      if (at != tails.begin()) before[i] = *(at - 1);
      if (at == tails.end()) {
        tails.push_back(i);
      } else {
        *at = i;
      }
    }
    std::vector<bool> is_part(n, false);
    for (std::optional<std::size_t> i = tails.back(); i; i = before[*i]) is_part[*i] = true;
    return is_part;
  }

  const std::vector<std::string>& names_;
  const std::vector<std::size_t>& places_;
  std::size_t begin_ = 0, end_ = places_.size();
};

}  // namespace

std::string describe_order(const std::vector<std::string>& names, const std::vector<std::size_t>& places) {
  assert(names.size() == places.size() && !std::ranges::is_sorted(places));
  return Reordering(names, places).describe();
}

}  // namespace contactsim
