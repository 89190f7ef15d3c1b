// SPDX-License-Identifier: BSD-3-Clause
#include "io/restart/restart_file.hpp"

#include <filesystem>
#include <fstream>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/file_size_limit.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

const std::vector<double> velocity{1.5, -2.25, 1e-308};
const std::vector<std::uint32_t> partners{7, 0xffffffffu};

SavedState sample_state() {
  SavedState state;
  state.add_view("nodes/velocity", std::span<const double>(velocity));
  state.add_copy("contact/faces/partners", std::span<const std::uint32_t>(partners));
  state.add_copy("contact/faces/touched", std::span<const std::uint8_t>());
  state.add_copy("contact/searched_at", std::span<const float>(std::vector<float>{0.1f}));
  state.add_copy("contact/glued", std::span<const std::uint64_t>(std::vector<std::uint64_t>{1ull << 63}));
  return state;
}

std::string error_of(const std::string& path) {
  try {
    read_restart_file(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a restart file gives back arrays and head", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.rsout.1");
  write_restart_file(path, {1700000000, 2, 1234, 0.1}, sample_state());
  const RestartHead head = read_restart_head(path);
  CHECK(head.begun == 1700000000);
  CHECK(head.run == 2);
  CHECK(head.step == 1234);
  CHECK(head.time == 0.1);
  const SavedState state = read_restart_file(path), before = sample_state();
  REQUIRE(state.arrays().size() == before.arrays().size());
  for (const SavedArray& array : before.arrays()) {
    const SavedArray* read = state.find(array.name);
    REQUIRE(read != nullptr);
    CHECK(read->type == array.type);
    CHECK(std::ranges::equal(read->bytes, array.bytes));
  }
}

TEST_CASE("a new state takes the place of an old one and leaves nothing else behind", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.rsout.1");
  write_restart_file(path, {0, 1, 1, 0.1}, sample_state());
  write_restart_file(path, {0, 1, 2, 0.2}, sample_state());
  CHECK(read_restart_head(path).step == 2);
  const std::filesystem::directory_iterator files(std::filesystem::path(path).parent_path());
  CHECK(std::distance(begin(files), end(files)) == 1);
}

TEST_CASE("every flipped bit in a restart file is found", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.rsout.1");
  write_restart_file(path, {0, 1, 1, 0.1}, sample_state());
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  const auto flip = [&](std::streamoff byte) {
    const int changed = file.seekg(byte).get() ^ (1 << (byte % 8));
    file.seekp(byte).put(static_cast<char>(changed)).flush();
  };
  std::size_t n_unnoticed = 0;
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
  for (std::streamoff byte = 0; byte < size; ++byte) {
    flip(byte);
    n_unnoticed += error_of(path).empty() ? 1 : 0;
    flip(byte);
  }
  CHECK(n_unnoticed == 0);
  CHECK(error_of(path) == "");
}

TEST_CASE("a restart file that is cut, or longer, is found", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.rsout.1");
  write_restart_file(path, {0, 1, 1, 0.1}, sample_state());
  const std::string good = read_bytes(path);
  const std::size_t n = GENERATE_COPY(std::size_t{0}, std::size_t{20}, std::size_t{511}, std::size_t{512},
                                      good.size() / 2, good.size() - 1);
  write_bytes(path, good.substr(0, n));
  CHECK_THAT(error_of(path), Contains("a.rsout.1: is "));
  write_bytes(path, good + '\0');
  CHECK_THAT(error_of(path), Contains("is damaged: it has"));
}

TEST_CASE("another file is no restart file", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.rsout.1");
  CHECK_THAT(error_of(path), Contains("No such file"));
  write_bytes(path, std::string(4096, 'x'));
  CHECK_THAT(error_of(path), Contains("is no restart file"));
}

TEST_CASE("a state that finds no room leaves the old one as it was", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a.rsout.1");
  write_restart_file(path, {0, 1, 1, 0.1}, sample_state());
  const std::string good = read_bytes(path);
  const std::vector<double> many(100000, 1.0);
  SavedState large = sample_state();
  large.add_view("nodes/acceleration", std::span<const double>(many));
  {
    const FileSizeLimit limit(100000);
    CHECK_THROWS_WITH(write_restart_file(path, {0, 1, 2, 0.2}, large), Contains("cannot be written"));
  }
  CHECK(read_bytes(path) == good);
  CHECK_FALSE(std::filesystem::exists(path + ".part"));
}

TEST_CASE("a folder that is not there is named", "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("nowhere/a.rsout.1");
  CHECK_THROWS_WITH(write_restart_file(path, {}, sample_state()), Contains("nowhere/a.rsout.1"));
}
