// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/record_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

// Large enough that calls cost nothing, small enough to stay in the cache.
constexpr std::size_t n_buffered_values = 1u << 15;

// Byte i of n of a number, the most significant first.
char byte_of(std::uint64_t number, int i, int n) {
  return static_cast<char>(static_cast<unsigned char>(number >> (8 * (n - 1 - i))));
}

std::uint64_t to_big_endian(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return std::endian::native == std::endian::little ? __builtin_bswap64(bits) : bits;
}

}  // namespace

RecordFile::RecordFile(std::string path)
    : path_(std::move(path)),
      layout_(read_record_layout(path_)),
      file_(open(path_.c_str(), O_RDWR | O_CLOEXEC)) {
  if (!file_.is_open()) fail(errno);
  buffer_.resize(n_buffered_values * sizeof(double));
}

void RecordFile::fail(int error) {
  if (file_.is_open()) {
    // A record that was begun would only take room.
    const std::uint64_t end = layout_.begin + layout_.n_records * layout_.record_size;
    [[maybe_unused]] const int ignored = ftruncate(file_.number(), static_cast<off_t>(end));
  }
  file_.close();
  throw FileError(path_, "cannot be written (" + std::generic_category().message(error) + ")");
}

void RecordFile::write(const std::string& variable, std::span<const double> values, Stride stride,
                       std::size_t first) {
  const auto place = layout_.places.find(variable);
  assert(place != layout_.places.end());
  std::uint64_t position =
      layout_.begin + layout_.n_records * layout_.record_size + place->second + first * sizeof(double);
  std::size_t n_buffered = 0;
  for (std::size_t i = stride.first; i < values.size(); i += stride.stride) {
    const std::uint64_t bits = to_big_endian(values[i]);
    std::memcpy(buffer_.data() + n_buffered * sizeof bits, &bits, sizeof bits);
    if (++n_buffered < n_buffered_values) continue;
    write_bytes(buffer_, position);
    position += buffer_.size();
    n_buffered = 0;
  }
  write_bytes(std::span(buffer_).first(n_buffered * sizeof(double)), position);
}

void RecordFile::end_record() {
  const int n_bytes = layout_.n_count_bytes;
  std::array<char, 8> count{};
  for (int i = 0; i < n_bytes; ++i) {
    count[static_cast<std::size_t>(i)] = byte_of(layout_.n_records + 1, i, n_bytes);
  }
  constexpr std::uint64_t after_magic_number = 4;
  write_bytes(std::span(count).first(static_cast<std::size_t>(n_bytes)), after_magic_number);
  ++layout_.n_records;
}

void RecordFile::write_bytes(std::span<const char> bytes, std::uint64_t position) {
  if (!file_.is_open()) throw FileError(path_, "was closed when it could not be written");
  while (!bytes.empty()) {
    const ssize_t n = pwrite(file_.number(), bytes.data(), bytes.size(), static_cast<off_t>(position));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    position += static_cast<std::uint64_t>(n);
  }
}

}  // namespace contactsim
