// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/byte_mutator.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "campaigns/meshes/file_bytes.hpp"

namespace contactsim::test {

namespace {

constexpr std::array<std::uint64_t, 24> hostile{
    0,    1,      2,          3,          10,         11,          12,          13,          127,
    255,  256,    257,        65535,      0x7fffffff, 0x80000000u, 0xfffffffcu, 0xffffffffu, 0x100000000u,
    1000, 100000, 0x3fffffff, 1ull << 62, 1ull << 63, ~0ull};

void put_number(std::string& bytes, std::size_t at, std::size_t n_bytes, std::uint64_t value,
                bool is_big_endian) {
  for (std::size_t i = 0; i < n_bytes && at + i < bytes.size(); ++i) {
    const std::size_t shift = is_big_endian ? n_bytes - 1 - i : i;
    bytes[at + i] = static_cast<char>(value >> 8 * shift & 0xff);
  }
}

void change_anywhere(std::string& bytes, CaseRandom& random) {
  const std::size_t at = random.below(bytes.size());
  switch (random.below(4)) {
    case 0:
      bytes.resize(at);
      break;
    case 1:
      bytes.erase(at, 1 + random.below(64));
      break;
    case 2: {
      const std::size_t n = 1 + random.below(64);  // before the byte: arguments are evaluated in any order
      bytes.insert(at, n, static_cast<char>(random.below(256)));
      break;
    }
    default:
      bytes[at] = static_cast<char>(bytes[at] ^ 1 << random.below(8));
  }
}

void change_classic(std::string& bytes, CaseRandom& random) {
  const std::vector<HeaderField> fields = find_classic_fields(bytes);
  if (fields.empty()) return;
  const HeaderField field = random.pick(fields);
  if (random.once_in(2)) {
    const std::uint64_t value = random.pick(hostile);
    put_number(bytes, field.begin, field.n_bytes, value, true);
  } else {
    const std::size_t at = field.begin + field.n_bytes - 1;
    bytes[at] = static_cast<char>(bytes[at] + (random.once_in(2) ? 1 : -1));
  }
}

void change_hdf5(std::string& bytes, CaseRandom& random) {
  const std::vector<std::size_t> structures = find_hdf5_structures(bytes);
  if (structures.empty()) return;
  const std::size_t begin = random.pick(structures);
  const std::size_t at = std::min(begin + 4 + random.below(random.once_in(2) ? 40 : 400), bytes.size() - 1);
  switch (random.below(4)) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ 1 << random.below(8));
      break;
    case 1:
      bytes[at] = static_cast<char>(random.below(256));
      break;
    case 2:
      bytes[at] = static_cast<char>(bytes[at] + (random.once_in(2) ? 1 : -1));
      break;
    default:
      const std::size_t n_bytes = std::size_t{1} << random.below(4);
      put_number(bytes, at, n_bytes, random.pick(hostile), false);
  }
}

}  // namespace

void mutate_bytes(std::string& bytes, CaseRandom& random) {
  const bool is_hdf5 = bytes.starts_with("\x89HDF");
  const bool is_mended = !random.once_in(8);
  for (std::size_t n = 1 + random.below(3); n > 0 && !bytes.empty(); --n) {
    if (random.once_in(12)) {
      change_anywhere(bytes, random);
    } else if (is_hdf5) {
      change_hdf5(bytes, random);
    } else {
      change_classic(bytes, random);
    }
  }
  if (is_hdf5 && is_mended) mend_hdf5_checksums(bytes);
}

}  // namespace contactsim::test
