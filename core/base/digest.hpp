// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace contactsim {

/// A fingerprint of bytes that come piece by piece; how they are cut does not matter. Every step is
/// invertible, so that bytes of equal length which differ within one aligned word of eight never have the
/// same. No protection against intent. Source: in the manner of FNV-1a (Fowler, Noll, Vo), a word at a time
/// and with a rotation.
class Digest {
 public:
  void add(std::span<const std::byte> bytes);
  /// Numbers as they are in memory.
  template <class T>
  void add_values(std::span<const T> values) {
    add(std::as_bytes(values));
  }
  std::uint64_t value() const;

 private:
  void add_word(std::uint64_t word);

  std::uint64_t mixed_ = 0xcbf29ce484222325u;
  std::uint64_t begun_ = 0;    // bytes that do not yet fill a word
  std::uint64_t n_bytes_ = 0;  // in all
};

/// The fingerprint of a text.
inline std::uint64_t digest_of(std::string_view text) {
  Digest digest;
  digest.add_values(std::span<const char>(text));
  return digest.value();
}

}  // namespace contactsim
