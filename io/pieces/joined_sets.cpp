// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/joined_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "io/pieces/side_factors.hpp"

namespace contactsim {

namespace {

/// What is different between the kinds of sets.
struct SetKind {
  DividedKind kind;
  const char *count, *dimension, *members, *factors, *what;
};

constexpr SetKind node_sets{DividedKind::node_set, "num_node_sets", "num_nod_ns", "node_ns",
                            "num_df_ns",           "node set"};
constexpr SetKind side_sets{DividedKind::side_set, "num_side_sets", "num_side_ss", "elem_ss",
                            "num_df_ss",           "side set"};
constexpr SetKind element_sets{
    DividedKind::element_set, "num_elem_sets", "num_ele_els", "elem_els", "num_df_els", "element set"};

/// Joins one set of all pieces.
class SetJoiner {
 public:
  SetJoiner(const std::vector<OpenPiece>& pieces, Division& division, const SetKind& kind, std::size_t number)
      : pieces_(pieces), division_(division), kind_(kind), number_(number) {}

  void join() {
    for (std::size_t p = 0; p < pieces_.size(); ++p) read_piece(p);
    DividedAxis axis = has_order_ ? by_order() : by_keys();
    if (axis.length == 0) return;
    for (const OpenPiece& piece : pieces_) check_plain_factors(piece);
    if (pieces_.front().layout.length(name(kind_.factors)) > 0 && kind_.kind != DividedKind::side_set)
      division_[name(kind_.factors)] = axis;
    if (kind_.kind == DividedKind::side_set) join_factors(axis);
    division_[name(kind_.dimension)] = std::move(axis);
  }

 private:
  std::string name(const char* prefix) const { return fmt::format("{}{}", prefix, number_); }

  [[noreturn]] void fail(std::size_t piece, const std::string& what) const {
    pieces_[piece].file->fail(fmt::format("{} number {}: {}", kind_.what, number_, what));
  }

  void read_piece(std::size_t p) {
    const OpenPiece& piece = pieces_[p];
    const std::size_t n = piece.layout.length(name(kind_.dimension));
    const auto members = piece.integers(name(kind_.members), n);
    if (members.size() != n)
      fail(p, fmt::format("has {} entries but no variable {}", n, name(kind_.members)));
    std::vector<std::int64_t> sides(n, 0);
    if (kind_.kind == DividedKind::side_set && n > 0) {
      sides = piece.integers(name("side_ss"), n);
      if (sides.size() != n) fail(p, fmt::format("has {} entries but no variable {}", n, name("side_ss")));
    }
    const auto& in_whole =
        division_.at(kind_.kind == DividedKind::node_set ? "num_nodes" : "num_elem").positions[p];
    std::vector<Key>& keys = keys_.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      if (members[i] < 1 || static_cast<std::uint64_t>(members[i]) > in_whole.size())
        fail(p, fmt::format("entry {} is {}, which is not in 1 to {}", i + 1, members[i], in_whole.size()));
      keys.push_back({in_whole[static_cast<std::size_t>(members[i]) - 1], sides[i]});
    }
    members_.push_back(members);
    orders_.push_back(piece.integers(set_order_name({kind_.kind, number_}), n));
    if (!orders_.back().empty()) has_order_ = true;
  }

  DividedAxis by_order() const {
    DividedAxis axis;
    std::int64_t length = 0;
    std::size_t n_entries = 0;
    for (std::size_t p = 0; p < orders_.size(); ++p) {
      if (orders_[p].size() != keys_[p].size())
        fail(p, "does not say where its entries stand in the whole set, as other pieces do");
      n_entries += orders_[p].size();
      for (const std::int64_t place : orders_[p]) length = std::max(length, place);
    }
    if (static_cast<std::uint64_t>(length) > n_entries) fail(0, "entries of the whole set are in no piece");
    axis.length = static_cast<std::size_t>(length);
    std::vector<std::uint8_t> is_there(axis.length, 0);
    for (std::size_t p = 0; p < orders_.size(); ++p) {
      std::vector<std::uint32_t>& positions = axis.positions.emplace_back();
      for (const std::int64_t place : orders_[p]) {
        if (place < 1) fail(p, fmt::format("an entry stands at {} in the whole set", place));
        positions.push_back(static_cast<std::uint32_t>(place - 1));
        is_there[positions.back()] = 1;
      }
    }
    if (std::ranges::find(is_there, 0) != is_there.end()) fail(0, "entries of the whole set are in no piece");
    return axis;
  }

  DividedAxis by_keys() const {
    std::vector<Key> all;
    for (const std::vector<Key>& keys : keys_) all.insert(all.end(), keys.begin(), keys.end());
    std::ranges::sort(all);
    const bool is_shared = kind_.kind == DividedKind::node_set;
    if (is_shared) all.erase(std::unique(all.begin(), all.end()), all.end());
    DividedAxis axis{all.size(), {}};
    // What stands in a set twice keeps its places one after the other.
    std::vector<std::uint32_t> n_taken(is_shared ? 0 : all.size(), 0);
    for (const std::vector<Key>& keys : keys_) {
      std::vector<std::uint32_t>& positions = axis.positions.emplace_back();
      for (const Key& key : keys) {
        auto position = static_cast<std::uint32_t>(std::ranges::lower_bound(all, key) - all.begin());
        if (!is_shared) position += n_taken[position]++;
        positions.push_back(position);
      }
    }
    return axis;
  }

  /// Factors of nodes and elements are one for each.
  void check_plain_factors(const OpenPiece& piece) const {
    if (kind_.kind == DividedKind::side_set) return;
    const std::size_t n = piece.layout.length(name(kind_.factors));
    if (n == 0 || n == piece.layout.length(name(kind_.dimension))) return;
    piece.file->fail(fmt::format("{} number {}: {} distribution factors where {} belong", kind_.what, number_,
                                 n, piece.layout.length(name(kind_.dimension))));
  }

  void join_factors(const DividedAxis& sides) {
    std::vector<std::vector<std::size_t>> counts;
    std::vector<std::size_t> begins(sides.length + 1, 0);
    bool has_factors = false;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const std::size_t n = pieces_[p].layout.length(name(kind_.factors));
      has_factors = has_factors || n > 0;
      counts.push_back(n > 0 ? count_factors(p, n) : std::vector<std::size_t>(keys_[p].size(), 0));
      for (std::size_t i = 0; i < counts[p].size(); ++i) begins[sides.positions[p][i] + 1] = counts[p][i];
    }
    if (!has_factors) return;
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    DividedAxis factors{begins.back(), {}};
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      std::vector<std::uint32_t>& positions = factors.positions.emplace_back();
      for (std::size_t i = 0; i < counts[p].size(); ++i) {
        for (std::size_t f = 0; f < counts[p][i]; ++f)
          positions.push_back(static_cast<std::uint32_t>(begins[sides.positions[p][i]] + f));
      }
    }
    division_[name(kind_.factors)] = std::move(factors);
  }

  std::vector<std::size_t> count_factors(std::size_t p, std::size_t n) const {
    const ElementShapes shapes(*pieces_[p].file, pieces_[p].layout);
    std::vector<ShapedSide> shaped;
    for (std::size_t i = 0; i < members_[p].size(); ++i)
      shaped.push_back({shapes.of(static_cast<std::size_t>(members_[p][i]) - 1), keys_[p][i].side});
    auto counts = divide_factors(shaped, n);
    if (!counts) fail(p, fmt::format("{} distribution factors do not match its {} sides", n, shaped.size()));
    return std::move(*counts);
  }

  /// Where an entry stands in the whole set if nothing else is said.
  struct Key {
    std::uint32_t position = 0;  ///< of its node or element
    std::int64_t side = 0;
    auto operator<=>(const Key&) const = default;
  };

  const std::vector<OpenPiece>& pieces_;
  Division& division_;
  const SetKind& kind_;
  std::size_t number_;
  std::vector<std::vector<Key>> keys_;
  std::vector<std::vector<std::int64_t>> members_, orders_;
  bool has_order_ = false;
};

}  // namespace

void join_sets(const std::vector<OpenPiece>& pieces, Division& division) {
  for (const SetKind* kind : {&node_sets, &side_sets, &element_sets}) {
    const std::size_t n = pieces.front().layout.length(kind->count);
    for (std::size_t number = 1; number <= n; ++number) SetJoiner(pieces, division, *kind, number).join();
  }
}

}  // namespace contactsim
