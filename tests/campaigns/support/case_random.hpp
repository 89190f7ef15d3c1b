// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace contactsim::test {

/// Random numbers of one case of a campaign: the same for the same campaign, seed and case on every machine,
/// therefore without the distributions of <random>.
/// Source: SplitMix64 (Steele, Lea & Flood, OOPSLA 2014); FNV-1a for the name.
class CaseRandom {
 public:
  CaseRandom(std::string_view campaign, std::uint64_t seed, std::uint64_t number) {
    state_ = 0xcbf29ce484222325u;
    for (const char c : campaign) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    state_ += seed;
    state_ = next() + number;
    next();
  }

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }

  /// 0 to n - 1. Precondition: 0 < n < 2^32.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>((next() >> 32) * n >> 32); }
  /// True once in n times.
  bool once_in(std::size_t n) { return below(n) == 0; }
  /// Precondition: not empty.
  template <class Items>
  const auto& pick(const Items& items) {
    return items[below(std::size(items))];
  }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace contactsim::test
