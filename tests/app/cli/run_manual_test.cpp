// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_manual.hpp"

#include <filesystem>

#include "app/manual/sample_commands.hpp"
#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

std::size_t n_files_below(const std::string& folder) {
  std::size_t n = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    n += entry.is_regular_file() ? 1 : 0;
  return n;
}

}  // namespace

TEST_CASE("every kind of manual is written below a folder, the same each time", "[app][manual]") {
  CHECK(manual_kinds() ==
        std::vector<std::string>{"man", "man-deck", "html", "bash", "zsh", "fish", "vim", "vscode"});
  for (const std::string& kind : manual_kinds()) {
    INFO(kind);
    const TemporaryDirectory directory;
    const ManualOptions options{true, kind, directory.file("a/b"), sample_commands()};
    CHECK(run_manual(options) == ExitCode::done);
    const std::size_t n_files = n_files_below(directory.file("a/b"));
    CHECK(n_files > 0);
    CHECK(run_manual(options) == ExitCode::done);
    CHECK(n_files_below(directory.file("a/b")) == n_files);
  }
}

TEST_CASE("a folder in which a manual cannot be written is a file error", "[app][manual]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("taken"), "");
  CHECK_THROWS_WITH(run_manual({true, "bash", directory.file("taken"), sample_commands()}),
                    Contains("taken/") && Contains("cannot be written"));
}

TEST_CASE("a manual of one file is printed, of several it takes a folder", "[app][manual]") {
  const ProgramDirectory directory;
  const auto one = directory.run({"manual", "Bash"});
  CHECK(one.exit_code == 0);
  CHECK(one.err == "");
  CHECK(one.out.starts_with("# bash completion of contactsim"));
  const auto several = directory.run({"manual", "vim"});
  CHECK(several.exit_code == 2);
  CHECK(several.out == "");
  CHECK(several.err == "error: vim is 3 files: give a folder for them\n");
  CHECK(directory.list().empty());
}
