// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace contactsim {

/// The processes that make one run together, numbered from 0, as ranks of MPI. Each has the whole model and
/// walks through the same program with the same numbers; what a rank alone has worked out reaches the others
/// by these calls, which all make in the same order.
class Ranks {
 public:
  Ranks(int rank, int count) : rank_(rank), count_(count) {}
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }
  bool are_several() const { return count_ > 1; }
  /// Rank 0 reads clocks, prints and writes files, but pieces of results.
  bool is_root() const { return rank_ == 0; }

  /// Every rank gets the parts of all.
  ///   all     the parts one after the other, that of this rank filled in
  ///   begins  [count + 1] where the part of each rank begins, the same on all ranks [bytes]
  virtual void gather(std::span<std::byte> all, std::span<const std::size_t> begins) = 0;
  /// Every rank gets the bytes of rank 0.
  virtual void broadcast(std::span<std::byte> bytes) = 0;
  /// A message between each two ranks; both know its size, which may be 0.
  ///   out  [count] to each rank; that to itself stays
  ///   in   [count] from each rank
  virtual void exchange(std::span<const std::span<const std::byte>> out,
                        std::span<const std::span<std::byte>> in) = 0;
  /// Waits for all ranks. Returns false when one does not come within the time [s].
  virtual bool wait_for_all(double seconds) = 0;
  /// Ends the processes of all ranks.
  [[noreturn]] virtual void abort(int exit_code) = 0;

  /// gather() of items that hold no pointers.
  ///   begins  [count + 1] where the items of each rank begin, the same on all ranks
  template <class Item>
  void gather_items(std::span<Item> all, std::span<const std::size_t> begins) {
    std::vector<std::size_t> in_bytes;
    for (const std::size_t begin : begins) in_bytes.push_back(begin * sizeof(Item));
    gather(std::as_writable_bytes(all), in_bytes);
  }

  /// The lists of all ranks, one after the other in the order of the ranks, of items that hold no pointers.
  template <class Item>
  std::vector<Item> join(const std::vector<Item>& own) {
    std::vector<std::size_t> begins{0};
    for (const std::size_t n : of_all(own.size())) begins.push_back(begins.back() + n);
    std::vector<Item> all(begins.back());
    std::copy(own.begin(), own.end(),
              all.begin() + static_cast<std::ptrdiff_t>(begins[static_cast<std::size_t>(rank_)]));
    if (are_several() && !all.empty()) gather_items(std::span(all), begins);
    return all;
  }

  /// Marks on all ranks what any of them has marked.
  ///   marks  [n] 0 or 1, n the same on all ranks
  void unite(std::span<std::uint8_t> marks);

  /// The value of rank 0.
  template <class Value>
  Value of_root(Value value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (are_several()) broadcast(std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }

  /// The values of all ranks, in their order.
  template <class Value>
  std::vector<Value> of_all(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    std::vector<Value> values(static_cast<std::size_t>(count_), value);
    if (!are_several()) return values;
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i <= values.size(); ++i) begins.push_back(i);
    gather_items(std::span(values), begins);
    return values;
  }

 private:
  int rank_, count_;
};

/// A process by itself.
class OneRank final : public Ranks {
 public:
  OneRank() : Ranks(0, 1) {}
  void gather(std::span<std::byte> /*all*/, std::span<const std::size_t> /*begins*/) override {}
  void broadcast(std::span<std::byte> /*bytes*/) override {}
  void exchange(std::span<const std::span<const std::byte>> /*out*/,
                std::span<const std::span<std::byte>> /*in*/) override {}
  bool wait_for_all(double /*seconds*/) override { return true; }
  [[noreturn]] void abort(int exit_code) override;
};

/// Of a program that nobody has started on several ranks: never null.
Ranks& one_rank();

}  // namespace contactsim
