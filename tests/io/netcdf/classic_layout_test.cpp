// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/classic_layout.hpp"

#include <random>

#include "core/base/errors.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

std::string classic_bytes(FileFormat format) {
  const TemporaryDirectory directory;
  write_exodus(directory.file("mesh.g"), sample_mesh().build(), {.format = format});
  return read_bytes(directory.file("mesh.g"));
}

// True when the file was read, false when it was refused; anything else ends the test.
bool is_read(const std::string& path) {
  Diagnostics warnings;
  try {
    read_mesh(path, warnings);
    return true;
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace

TEST_CASE("a classic file that lost any of its end is refused", "[io][layout]") {
  const FileFormat format = GENERATE(FileFormat::cdf1, FileFormat::cdf2, FileFormat::cdf5);
  const TemporaryDirectory directory;
  const std::string path = directory.file("cut.g"), whole = classic_bytes(format);
  write_bytes(path, whole);
  CHECK_NOTHROW(check_classic_layout(path));
  // The last variable may be padded to four bytes: those are no loss.
  for (std::size_t size = 4; size + 4 <= whole.size(); size += 31) {
    write_bytes(path, std::string_view(whole).substr(0, size));
    CHECK_THROWS_AS(check_classic_layout(path), FileError);
  }
}

TEST_CASE("a cut-off file says so", "[io][layout]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("cut.g"), whole = classic_bytes(FileFormat::cdf2);
  write_bytes(path, std::string_view(whole).substr(0, whole.size() - 100));
  CHECK_THROWS_WITH(check_classic_layout(path), Contains("truncated: variable"));
  write_bytes(path, std::string_view(whole).substr(0, 300));
  CHECK_THROWS_WITH(check_classic_layout(path),
                    Contains("damaged netCDF header: the file ends inside it (at byte 300)"));
}

TEST_CASE("records are counted in the size of a file", "[io][layout]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("records.g");
  write_exodus(path, two_hexes().build());
  {
    ExodusEditor editor(path);
    editor.add_dimension("time_step", 0).add_records("time_whole", {"time_step"}, {1, 2, 3});
    const bool has_two_record_variables = GENERATE(false, true);
    if (has_two_record_variables) editor.add_records("other", {"time_step"}, {1, 2, 3});
  }
  const std::string whole = read_bytes(path);
  CHECK_NOTHROW(check_classic_layout(path));
  write_bytes(path, std::string_view(whole).substr(0, whole.size() - 8));
  CHECK_THROWS_WITH(check_classic_layout(path), Contains("truncated: variable"));
}

// HDF5 files are left out: their library is known to fail on forged files, and theirs is not our code to
// mend.
TEST_CASE("no damage to a classic file does more than have it refused", "[io][layout]") {
  const FileFormat format = GENERATE(FileFormat::cdf1, FileFormat::cdf2, FileFormat::cdf5);
  const TemporaryDirectory directory;
  const std::string path = directory.file("damaged.g"), whole = classic_bytes(format);
  std::mt19937 random(20250101u + static_cast<unsigned>(format));
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  int n_refused = 0;
  for (int variant = 0; variant < 1000; ++variant) {
    std::string bytes = whole;
    // Half of the variants hurt the header, where the counts are.
    const std::size_t reach = variant % 2 == 0 ? bytes.size() : std::min<std::size_t>(bytes.size(), 5000);
    for (std::size_t i = 0, n = 1 + below(4); i < n; ++i) {
      const std::size_t at = below(reach);
      bytes[at] =
          variant % 3 == 0 ? static_cast<char>(random()) : static_cast<char>(bytes[at] ^ (1 << below(8)));
    }
    if (variant % 10 == 0) bytes.resize(below(bytes.size()));
    write_bytes(path, bytes);
    if (!is_read(path)) ++n_refused;
  }
  CHECK(n_refused > 200);
  CHECK(n_refused < 1000);
}
