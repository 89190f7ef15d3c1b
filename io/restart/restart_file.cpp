// SPDX-License-Identifier: BSD-3-Clause
#include "io/restart/restart_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/digest.hpp"
#include "core/base/errors.hpp"
#include "core/base/version.hpp"
#include "io/files/output_place.hpp"
#include "io/restart/hdf5_arrays.hpp"

namespace contactsim {

namespace {

constexpr std::size_t head_size = 512;
using HeadBytes = std::array<char, head_size>;

constexpr std::string_view first_line = "contactsim restart 1\n";

/// The checksum comes first, at a place of its own.
constexpr std::string_view checksum_word = "checksum ";
constexpr std::size_t checksum_place = first_line.size() + checksum_word.size();
constexpr std::size_t checksum_length = 16;

/// A file of the system, open.
class Descriptor {
 public:
  Descriptor(const std::string& path, std::string named, int flags)
      : named_(std::move(named)),
        is_written_((flags & O_WRONLY) != 0),
        id_(open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (id_ < 0) fail(errno);
  }
  ~Descriptor() { ::close(id_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int id() const { return id_; }
  [[noreturn]] void fail(int error) const {
    throw FileError(named_, fmt::format("cannot be {} ({})", is_written_ ? "written" : "read",
                                        std::generic_category().message(error)));
  }
  /// Fills the bytes as far as the file goes, and says how many there were.
  std::size_t read(std::span<char> bytes) const {
    std::size_t n_read = 0;
    while (n_read < bytes.size()) {
      const ssize_t n = ::read(id_, bytes.data() + n_read, bytes.size() - n_read);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail(errno);
      if (n == 0) break;
      n_read += static_cast<std::size_t>(n);
    }
    return n_read;
  }

 private:
  std::string named_;
  bool is_written_;
  int id_;
};

HeadBytes make_head(const RestartHead& head, std::uint64_t n_bytes, std::uint64_t checksum) {
  HeadBytes bytes{};
  fmt::format_to_n(bytes.data(), bytes.size(),
                   "{}{}{:0{}x}\nbytes {}\nprogram {}\nbegun {}\nrun {}\nstep {}\ntime {:.17g}\n", first_line,
                   checksum_word, checksum, checksum_length, n_bytes, version, head.begun, head.run,
                   head.step, head.time);
  return bytes;
}

/// Puts the head in front of what HDF5 has written.
void seal(const RestartHead& head, std::span<std::byte> bytes) {
  const auto put_head = [&](std::uint64_t checksum) {
    const HeadBytes text = make_head(head, bytes.size(), checksum);
    std::ranges::copy(std::as_bytes(std::span(text)), bytes.begin());
  };
  put_head(0);
  Digest digest;
  digest.add(bytes);
  put_head(digest.value());
}

/// What a file's head says, its checksum set to 0.
struct ReadHead {
  RestartHead head;
  std::uint64_t n_bytes = 0;
  std::string checksum;  // as it is written
  HeadBytes bytes{};
};

ReadHead read_head(const Descriptor& file, const std::string& path) {
  ReadHead read;
  const std::size_t n = file.read(read.bytes);
  const std::string text(read.bytes.data(), n);
  if (n < head_size || !text.starts_with(first_line)) throw FileError(path, "is no restart file");
  std::istringstream words(text.substr(first_line.size()));
  std::string word;
  words >> word >> read.checksum >> word >> read.n_bytes >> word >> word >> word >> read.head.begun >> word >>
      read.head.run >> word >> read.head.step >> word >> read.head.time;
  if (!words) throw FileError(path, "is damaged: its head cannot be read");
  std::fill_n(read.bytes.begin() + checksum_place, checksum_length, '0');
  return read;
}

/// The checksum of a head, itself 0, and what follows it in a file, and how many bytes all that is.
std::pair<std::uint64_t, std::uint64_t> sum_up(const HeadBytes& head, const Descriptor& file) {
  Digest digest;
  digest.add_values(std::span<const char>(head));
  std::uint64_t n_bytes = head_size;
  std::vector<char> piece(std::size_t{1} << 20);
  while (const std::size_t n = file.read(piece)) {
    digest.add_values(std::span<const char>(piece).first(n));
    n_bytes += n;
  }
  return {digest.value(), n_bytes};
}

/// Writes a whole file and sees it to the disk.
void write_file(const std::string& path, const std::string& named, std::span<const std::byte> bytes) {
  const Descriptor file(path, named, O_WRONLY | O_CREAT | O_TRUNC);
  while (!bytes.empty()) {
    const ssize_t n = ::write(file.id(), bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) file.fail(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  if (fsync(file.id()) != 0) file.fail(errno);
}

/// A new name lasts once its folder is on the disk. Some file systems cannot be asked.
void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const int id = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (id < 0) return;
  fsync(id);
  close(id);
}

}  // namespace

void write_restart_file(const std::string& path, const RestartHead& head, const SavedState& state) {
  const OutputPlace place(path);
  if (!place.is_regular()) throw FileError(path, "cannot be written (it is not a regular file)");
  Hdf5Image image(head_size, state);
  seal(head, image.bytes());
  try {
    write_file(place.unfinished(), path, image.bytes());
  } catch (...) {
    place.discard();
    throw;
  }
  const std::string problem = place.commit();
  if (!problem.empty()) throw FileError(path, "cannot be written (" + problem + ")");
  sync_folder_of(path);
}

RestartHead read_restart_head(const std::string& path) {
  return read_head(Descriptor(path, path, O_RDONLY), path).head;
}

SavedState read_restart_file(const std::string& path) {
  const Descriptor file(path, path, O_RDONLY);
  const ReadHead read = read_head(file, path);
  const auto [checksum, n_bytes] = sum_up(read.bytes, file);
  if (n_bytes != read.n_bytes)
    throw FileError(path, fmt::format("is damaged: it has {} of {} bytes", n_bytes, read.n_bytes));
  if (fmt::format("{:0{}x}", checksum, checksum_length) != read.checksum)
    throw FileError(path, "is damaged: its checksum is wrong");
  return read_hdf5(path);
}

}  // namespace contactsim
