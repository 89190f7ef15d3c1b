// SPDX-License-Identifier: BSD-3-Clause
// What is left of a results file when the run does not end well.
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "core/base/errors.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "io/exodus/sample_results.hpp"
#include "support/catch.hpp"
#include "support/file_size_limit.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

Mesh box(int n_cells) { return MeshBuilder().add_hexes({.cells = {n_cells, n_cells, n_cells}}).build(); }

/// Sizes of a results file after each step, the file without steps first.
std::vector<std::uintmax_t> sizes_by_step(SampleResults& results, int n_steps) {
  const TemporaryDirectory directory;
  ResultsWriter writer(directory.file("r.e"), results.mesh(), {}, results.fields());
  std::vector<std::uintmax_t> sizes{std::filesystem::file_size(directory.file("r.e"))};
  for (int step = 0; step < n_steps; ++step) {
    results.set_step(step);
    writer.write_step(step, results.values());
    sizes.push_back(std::filesystem::file_size(directory.file("r.e")));
  }
  return sizes;
}

void check_steps(const std::string& path, const SampleResults& results, std::size_t n_steps) {
  const NetcdfFile file(path);
  REQUIRE(read_times(file).size() == n_steps);
  for (std::size_t step = 0; step < n_steps; ++step) CHECK(results.is_step(file, step));
  Diagnostics warnings;
  CHECK(read_mesh(path, warnings).n_elements() == results.mesh().n_elements());
}

/// Writes steps without end and sends one byte after each.
[[noreturn]] void write_forever(const std::string& path, SampleResults& results, int pipe) noexcept {
  ResultsWriter writer(path, results.mesh(), {}, results.fields());
  for (int step = 0;; ++step) {
    results.set_step(step);
    writer.write_step(step, results.values());
    if (::write(pipe, "s", 1) != 1) _exit(1);
  }
}

/// Kills a writing process after n_steps at the least. Returns how many it had finished for sure.
std::size_t write_until_killed(const std::string& path, SampleResults& results, std::size_t n_steps) {
  int ends[2] = {};
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) write_forever(path, results, ends[1]);
  close(ends[1]);
  char byte = 0;
  std::size_t n_received = 0;
  while (n_received < n_steps && read(ends[0], &byte, 1) == 1) ++n_received;
  kill(child, SIGKILL);
  while (read(ends[0], &byte, 1) == 1) ++n_received;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  return n_received;
}

}  // namespace

TEST_CASE("a killed run leaves the steps that it has written", "[io][results]") {
  const TemporaryDirectory directory;
  const int n_cells = GENERATE(1, 12);
  SampleResults results(box(n_cells));
  for (std::size_t n_steps : {1u, 2u, 5u, 11u}) {
    const std::string path = directory.file("r.e");
    const std::size_t n_finished = write_until_killed(path, results, n_steps);
    CHECK(n_finished >= n_steps);
    const std::size_t n_found = read_times(NetcdfFile(path)).size();
    // The last step may have been finished and not yet reported.
    CHECK((n_found == n_finished || n_found == n_finished + 1));
    check_steps(path, results, n_found);
  }
}

TEST_CASE("a full disk is an error and leaves the earlier steps", "[io][results]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.e");
  // One mesh whose step fits into netCDF's buffer, one whose step does not.
  const int n_cells = GENERATE(1, 12);
  SampleResults results(box(n_cells));
  const auto sizes = sizes_by_step(results, 4);
  // Within the fourth step: at its first byte, in its middle, at its last byte.
  const int place = GENERATE(0, 1, 2);
  const std::uintmax_t room =
      std::vector{sizes[3], (sizes[3] + sizes[4]) / 2, sizes[4] - 1}[static_cast<std::size_t>(place)];
  ResultsWriter writer(path, results.mesh(), {}, results.fields());
  for (int step = 0; step < 3; ++step) {
    results.set_step(step);
    writer.write_step(step, results.values());
  }
  {
    const FileSizeLimit limit(room);
    results.set_step(3);
    CHECK_THROWS_WITH(writer.write_step(3.0, results.values()),
                      path + ": cannot be written (File too large)");
  }
  CHECK(writer.n_steps() == 3);
  check_steps(path, results, 3);
  CHECK_THROWS_WITH(writer.write_step(3.0, results.values()),
                    path + ": was closed when it could not be written");
}

TEST_CASE("a disk too full for the mesh leaves the older file", "[io][results]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("r.e"), "old");
  SampleResults results(box(12));
  {
    const FileSizeLimit limit(20000);
    CHECK_THROWS_AS(ResultsWriter(directory.file("r.e"), results.mesh(), {}, results.fields()), FileError);
  }
  CHECK(read_bytes(directory.file("r.e")) == "old");
  CHECK_FALSE(std::filesystem::exists(directory.file("r.e.part")));
}

TEST_CASE("a 64-bit file on a full disk keeps its steps too", "[io][results]") {
  const TemporaryDirectory directory;
  MeshParts parts = two_hexes().parts();
  parts.element_ids = {std::int64_t{1} << 40, 1};
  SampleResults results{Mesh(parts)};
  const auto sizes = sizes_by_step(results, 2);
  {
    ResultsWriter writer(directory.file("r.e"), results.mesh(), {}, results.fields());
    results.set_step(0);
    writer.write_step(0, results.values());
    const FileSizeLimit limit(sizes[1] + 8);
    results.set_step(1);
    CHECK_THROWS_AS(writer.write_step(1, results.values()), FileError);
  }
  check_steps(directory.file("r.e"), results, 1);
}

TEST_CASE("a renamed file is still the one that is written and repaired", "[io][results]") {
  const TemporaryDirectory directory;
  SampleResults results(box(2));
  const auto sizes = sizes_by_step(results, 2);
  ResultsWriter writer(directory.file("r.e"), results.mesh(), {}, results.fields());
  std::filesystem::rename(directory.file("r.e"), directory.file("kept.e"));
  write_bytes(directory.file("r.e"), "another file");
  results.set_step(0);
  writer.write_step(0, results.values());
  {
    const FileSizeLimit limit(sizes[1] + 8);
    CHECK_THROWS_AS(writer.write_step(1, results.values()), FileError);
  }
  check_steps(directory.file("kept.e"), results, 1);
  CHECK(read_bytes(directory.file("r.e")) == "another file");
}
