// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/end_at_once.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a process ends at once with its line and code", "[core][base]") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    end_at_once(ExitCode::file, {"error: ", "a.g", " is gone"});
  }
  close(ends[1]);
  std::string text;
  char piece[100];
  for (ssize_t n_read = 0; (n_read = read(ends[0], piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(n_read));
  close(ends[0]);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(text == "error: a.g is gone\n");
  CHECK(WEXITSTATUS(status) == static_cast<int>(ExitCode::file));
}
