// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

constexpr std::size_t n_bytes_seen = 512;

bool is_text(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 ? byte != 0x7f : c == '\n' || c == '\r' || c == '\t' || c == '\f';
  });
}

void check_is_regular(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw FileError(path, "no such file");
  if (error) throw FileError(path, "cannot be opened (" + error.message() + ")");
  if (std::filesystem::is_directory(status)) throw FileError(path, "is a directory, not an Exodus mesh");
  if (!std::filesystem::is_regular_file(status)) throw FileError(path, "is not a regular file");
}

}  // namespace

FileKind find_file_kind(const std::string& path) {
  check_is_regular(path);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path, std::string("cannot be opened (") + std::strerror(errno) + ")");
  std::array<char, n_bytes_seen> buffer{};
  file.read(buffer.data(), buffer.size());
  const std::string_view start(buffer.data(), static_cast<std::size_t>(file.gcount()));

  if (start.empty()) throw FileError(path, "is empty (0 bytes), not an Exodus mesh");
  if (start.starts_with("CDF")) return FileKind::classic;
  if (start.starts_with("\x89HDF")) return FileKind::hdf5;
  if (start.starts_with("version https://git-lfs")) {
    throw FileError(path, "is a git-lfs pointer, not the mesh itself; fetch the mesh with 'git lfs pull'");
  }
  if (is_text(start)) throw FileError(path, "is a text file, not an Exodus mesh");
  return FileKind::other;
}

}  // namespace contactsim
