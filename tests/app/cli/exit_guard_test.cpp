// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/exit_guard.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <thread>

#include "core/base/memory_error.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

struct Guarded {
  ExitCode code;
  std::string written;
};

Guarded guarded(const std::function<ExitCode()>& work) {
  std::string written;
  const ExitCode code = guard_exit(work, [&](const std::string& line) { written += line + "|"; });
  return {code, written};
}

}  // namespace

TEST_CASE("work that throws nothing keeps its exit code and tells nothing", "[app][exit]") {
  const auto [code, written] = guarded([] { return ExitCode::solve; });
  CHECK(code == ExitCode::solve);
  CHECK(written == "");
}

TEST_CASE("a file error is reported and ends with code 3", "[app][exit]") {
  const auto [code, written] = guarded([]() -> ExitCode { throw FileError("a.g", "no such file"); });
  CHECK(static_cast<int>(code) == 3);
  CHECK(written == "error: a.g: no such file|");
}

TEST_CASE("an error of the solution is reported and ends with code 4, wherever it is thrown", "[app][exit]") {
  const auto [code, written] = guarded([]() -> ExitCode { throw SolveError(0.5, "node 7 is nowhere"); });
  CHECK(static_cast<int>(code) == 4);
  CHECK(written == "error: time 0.5: node 7 is nowhere|");
}

TEST_CASE("lack of memory ends with code 3, it is no bug", "[app][exit]") {
  const auto [code, written] = guarded([]() -> ExitCode { throw std::bad_alloc(); });
  CHECK(static_cast<int>(code) == 3);
  CHECK(written == "error: out of memory|");
  const auto reading = guarded([] {
    return tell_lack_of_memory("reading", [] {
      return tell_lack_of_memory("reading the mesh a.g", []() -> ExitCode { throw std::bad_alloc(); });
    });
  });
  CHECK(static_cast<int>(reading.code) == 3);
  CHECK(reading.written == "error: out of memory while reading the mesh a.g|");
}

TEST_CASE("lack of memory on a thread of a loop ends with code 3, too", "[app][exit]") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    end_without_memory();
    constexpr std::size_t most = 1UL << 60;
    tell_lack_of_memory("running", [] { std::thread([] { std::string(most, ' '); }).join(); });
    _exit(0);
  }
  close(ends[1]);
  std::string written(200, '\0');
  const ssize_t n_read = read(ends[0], written.data(), written.size());
  close(ends[0]);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 3);
  REQUIRE(n_read > 0);
  CHECK(written.substr(0, static_cast<std::size_t>(n_read)) == "error: out of memory while running\n");
}

TEST_CASE("anything else that is thrown is called a bug of ours and ends with code 1", "[app][exit]") {
  const auto [code, written] = guarded([]() -> ExitCode { throw std::logic_error("index 7 of 5"); });
  CHECK(static_cast<int>(code) == 1);
  CHECK(written == "contactsim: a bug in the program: index 7 of 5|");
}
