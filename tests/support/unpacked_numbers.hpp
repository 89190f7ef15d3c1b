// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <zlib.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace contactsim::test {

inline std::vector<unsigned char> from_base64(const std::string& text) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  std::uint32_t word = 0;
  int n_bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    word = word << 6 | static_cast<std::uint32_t>(digits.find(c));
    n_bits += 6;
    if (n_bits < 8) continue;
    n_bits -= 8;
    bytes.push_back(static_cast<unsigned char>(word >> n_bits));
  }
  return bytes;
}

/// What pack_numbers was given, step by step the other way round.
inline std::vector<std::int64_t> unpack_numbers(const std::string& text, std::size_t n_columns,
                                                bool in_time) {
  const std::vector<unsigned char> packed = from_base64(text);
  std::vector<unsigned char> bytes(std::size_t{1} << 22);
  uLongf size = bytes.size();
  if (uncompress(bytes.data(), &size, packed.data(), packed.size()) != Z_OK)
    throw std::runtime_error("no zlib");
  bytes.resize(size);
  std::vector<std::int64_t> values;
  std::uint64_t rest = 0;
  int shift = 0;
  for (const unsigned char byte : bytes) {
    rest |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    shift += 7;
    if (byte & 0x80) continue;
    values.push_back(static_cast<std::int64_t>(rest >> 1) ^ -static_cast<std::int64_t>(rest & 1));
    rest = 0;
    shift = 0;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % n_columns > 0) values[i] += values[i - 1];
  }
  for (std::size_t i = n_columns; in_time && i < values.size(); ++i) values[i] += values[i - n_columns];
  return values;
}

}  // namespace contactsim::test
