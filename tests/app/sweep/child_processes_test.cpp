// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/child_processes.hpp"

#include <unistd.h>

#include <csignal>

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;

namespace {

EndedChild wait(ChildProcesses& children) {
  for (;;) {
    if (const auto ended = children.take_ended()) return *ended;
    usleep(1000);
  }
}

/// A line of shell that runs in the directory.
ChildCommand shell(const test::TemporaryDirectory& directory, const std::string& line) {
  return {{"/bin/sh", "-c", line}, directory.file(""), directory.file("errors")};
}

}  // namespace

TEST_CASE("children run in their folder and tell how they ended", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  ChildProcesses children;
  children.start(7, shell(directory, "pwd > here; echo wrong >&2; exit 4"));
  CHECK(children.n_running() == 1);
  const EndedChild ended = wait(children);
  CHECK(ended.number == 7);
  CHECK(ended.exit_code == 4);
  CHECK(children.n_running() == 0);
  CHECK(test::read_bytes(directory.file("here")) + "x" != "x");
  CHECK(test::read_bytes(directory.file("errors")) == "wrong\n");
}

TEST_CASE("a signal reaches all children and shows in how they end", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  ChildProcesses children;
  children.start(1, shell(directory, "exec sleep 60"));
  children.start(2, shell(directory, "exec sleep 60"));
  children.send(SIGTERM);
  CHECK(wait(children).exit_code == 128 + SIGTERM);
  CHECK(wait(children).exit_code == 128 + SIGTERM);
}

TEST_CASE("a program that cannot be run ends with code 127", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  ChildProcesses children;
  children.start(1, {{"/no/such/program"}, directory.file(""), directory.file("errors")});
  CHECK(wait(children).exit_code == 127);
}
