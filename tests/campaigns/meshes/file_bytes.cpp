// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/file_bytes.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace contactsim::test {

namespace {

/// Walks through a classic header and notes its numbers.
class HeaderWalk {
 public:
  explicit HeaderWalk(const std::string& bytes) : bytes_(bytes) {}

  std::vector<HeaderField> walk() {
    is_large_ = bytes_.size() > 3 && bytes_[3] == 5;
    const std::size_t offset_bytes = bytes_.size() > 3 && bytes_[3] == 1 ? 4 : 8;
    at_ = 4;
    count();  // records
    for (std::uint64_t n = list(); n > 0 && !is_over(); --n) {
      name();
      count();
    }
    attributes();
    for (std::uint64_t n = list(); n > 0 && !is_over(); --n) {
      name();
      for (std::uint64_t rank = count(); rank > 0 && !is_over(); --rank) count();
      attributes();
      number(4);
      count();
      number(offset_bytes);
    }
    return std::move(fields_);
  }

 private:
  bool is_over() const { return at_ >= bytes_.size(); }
  std::uint64_t number(std::size_t n_bytes) {
    if (at_ + n_bytes > bytes_.size()) {
      at_ = bytes_.size();
      return 0;
    }
    fields_.push_back({at_, n_bytes});
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < n_bytes; ++i) value = value << 8 | static_cast<unsigned char>(bytes_[at_++]);
    return value;
  }
  std::uint64_t count() { return number(is_large_ ? 8 : 4); }
  std::uint64_t list() {
    number(4);  // the tag
    return count();
  }
  void skip(std::uint64_t n_bytes) {
    at_ = std::min<std::uint64_t>(bytes_.size(), at_ + (n_bytes + 3) / 4 * 4);
  }
  void name() { skip(count()); }
  void attributes() {
    constexpr std::array<std::uint64_t, 12> sizes{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    for (std::uint64_t n = list(); n > 0 && !is_over(); --n) {
      name();
      const std::uint64_t type = number(4), n_values = count();
      skip(n_values * sizes[type < sizes.size() ? type : 0]);
    }
  }

  const std::string& bytes_;
  std::vector<HeaderField> fields_;
  std::size_t at_ = 0;
  bool is_large_ = false;
};

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

void put_checksum(std::string& bytes, std::size_t begin, std::size_t n) {
  if (begin + n + 4 > bytes.size()) return;
  const std::uint32_t sum = hdf5_checksum(bytes, begin, n);
  for (std::size_t i = 0; i < 4; ++i) bytes[begin + n + i] = static_cast<char>(sum >> 8 * i & 0xff);
}

/// Length of the first part of an object header before its checksum; 0 when it is not in the file.
std::size_t header_length(const std::string& bytes, std::size_t begin) {
  if (begin + 40 > bytes.size()) return 0;
  const auto flags = static_cast<unsigned char>(bytes[begin + 5]);
  std::size_t at = begin + 6 + ((flags & 0x20u) != 0 ? 16 : 0) + ((flags & 0x10u) != 0 ? 4 : 0);
  std::uint64_t size = 0;
  const std::size_t n_bytes = std::size_t{1} << (flags & 3u);
  for (std::size_t i = n_bytes; i-- > 0;) size = size << 8 | static_cast<unsigned char>(bytes[at + i]);
  at += n_bytes;
  return size < bytes.size() && at + size + 4 <= bytes.size() ? at + size - begin : 0;
}

}  // namespace

std::vector<HeaderField> find_classic_fields(const std::string& bytes) { return HeaderWalk(bytes).walk(); }

std::vector<std::size_t> find_hdf5_structures(const std::string& bytes) {
  constexpr std::array<const char*, 13> signatures{"\x89HDF", "OHDR", "OCHK", "TREE", "BTHD", "BTLF", "BTIN",
                                                   "HEAP",    "SNOD", "FRHP", "FHDB", "FSHD", "GCOL"};
  std::vector<std::size_t> found;
  for (const char* signature : signatures) {
    for (std::size_t at = bytes.find(signature); at != bytes.npos; at = bytes.find(signature, at + 1))
      found.push_back(at);
  }
  return found;
}

// Bob Jenkins, lookup3 (2006, public domain): three words are mixed by twelve bytes.
std::uint32_t hdf5_checksum(const std::string& bytes, std::size_t begin, std::size_t n) {
  std::uint32_t a = 0xdeadbeefu + static_cast<std::uint32_t>(n), b = a, c = a;
  for (; n > 12; n -= 12, begin += 12) {
    a += word_at(bytes, begin);
    b += word_at(bytes, begin + 4);
    c += word_at(bytes, begin + 8);
    a = (a - c) ^ std::rotl(c, 4), c += b;
    b = (b - a) ^ std::rotl(a, 6), a += c;
    c = (c - b) ^ std::rotl(b, 8), b += a;
    a = (a - c) ^ std::rotl(c, 16), c += b;
    b = (b - a) ^ std::rotl(a, 19), a += c;
    c = (c - b) ^ std::rotl(b, 4), b += a;
  }
  if (n == 0) return c;
  std::string last = bytes.substr(begin, n);
  last.resize(12, '\0');
  a += word_at(last, 0);
  b += word_at(last, 4);
  c += word_at(last, 8);
  c = (c ^ b) - std::rotl(b, 14);
  a = (a ^ c) - std::rotl(c, 11);
  b = (b ^ a) - std::rotl(a, 25);
  c = (c ^ b) - std::rotl(b, 16);
  a = (a ^ c) - std::rotl(c, 4);
  b = (b ^ a) - std::rotl(a, 14);
  return (c ^ b) - std::rotl(b, 24);
}

void mend_hdf5_checksums(std::string& bytes) {
  constexpr std::size_t superblock_bytes = 44;
  if (bytes.size() > superblock_bytes && bytes.starts_with("\x89HDF") && bytes[8] >= 2)
    put_checksum(bytes, 0, superblock_bytes);
  for (std::size_t at = bytes.find("OHDR"); at != bytes.npos; at = bytes.find("OHDR", at + 1)) {
    if (const std::size_t n = header_length(bytes, at); n > 0) put_checksum(bytes, at, n);
  }
}

}  // namespace contactsim::test
