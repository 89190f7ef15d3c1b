// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/digest.hpp"

#include <algorithm>
#include <cstring>

namespace contactsim {

namespace {

constexpr std::size_t word_size = sizeof(std::uint64_t);

std::uint64_t mix(std::uint64_t mixed, std::uint64_t word) {
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15u;  // 2^64 over the golden ratio
  mixed = (mixed ^ word) * odd;
  return mixed ^ (mixed >> 32);  // a product moves bits up only
}

}  // namespace

void Digest::add_word(std::uint64_t word) { mixed_ = mix(mixed_, word); }

void Digest::add(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;  // no bytes may be nowhere, which memcpy must not be given
  const std::size_t n_begun = n_bytes_ % word_size;
  n_bytes_ += bytes.size();
  if (n_begun > 0) {
    const std::size_t n = std::min(word_size - n_begun, bytes.size());
    std::memcpy(reinterpret_cast<std::byte*>(&begun_) + n_begun, bytes.data(), n);
    bytes = bytes.subspan(n);
    if (n_begun + n < word_size) return;
    add_word(begun_);
    begun_ = 0;
  }
  for (; bytes.size() >= word_size; bytes = bytes.subspan(word_size)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), word_size);
    add_word(word);
  }
  if (!bytes.empty()) std::memcpy(&begun_, bytes.data(), bytes.size());
}

std::uint64_t Digest::value() const { return mix(mix(mixed_, begun_), n_bytes_); }

}  // namespace contactsim
