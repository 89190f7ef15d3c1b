// SPDX-License-Identifier: BSD-3-Clause
#include "io/restart/restart_database.hpp"

#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

void write_state(const std::string& database, std::int64_t slot, const RestartHead& head) {
  write_restart_file(restart_path(database, head.run, slot), head, SavedState());
}

std::vector<std::int64_t> slots(RestartSlots counter, int n) {
  std::vector<std::int64_t> taken;
  for (int i = 0; i < n; ++i) taken.push_back(counter.take());
  return taken;
}

}  // namespace

TEST_CASE("states are numbered, those of later runs under names of their own", "[io][restart]") {
  CHECK(restart_path("a.rsout", 1, 3) == "a.rsout.3");
  CHECK(restart_path("out/a.rsout", 2, 1) == "out/a.rsout-s0002.1");
  CHECK(run_suffix(1) == "");
  CHECK(run_suffix(12) == "-s0012");
}

TEST_CASE("a database is found with the latest state first and without files of other names",
          "[io][restart]") {
  const TemporaryDirectory directory;
  const std::string database = directory.file("a.rsout");
  write_state(database, 1, {100, 1, 50, 0.5});
  write_state(database, 2, {100, 1, 60, 0.6});
  write_state(database, 1, {100, 2, 55, 0.55});
  write_state(database, 3, {90, 1, 900, 9.0});
  write_state(directory.file("b.rsout"), 1, {});
  write_bytes(database + ".1.part", "half");
  write_bytes(database + ".old", "other");
  write_bytes(database + "-s2", "other");
  std::vector<std::string> unusable;
  std::vector<std::int64_t> steps;
  for (const StoredState& state : find_stored_states(database, unusable)) steps.push_back(state.head.step);
  CHECK(steps == std::vector<std::int64_t>{55, 60, 50, 900});
  CHECK(unusable.empty());
}

TEST_CASE("a state whose head is cut is reported", "[io][restart]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a.rsout.1"), "contactsim restart 1\n");
  std::vector<std::string> unusable;
  CHECK(find_stored_states(directory.file("a.rsout"), unusable).empty());
  CHECK(unusable.size() == 1);
  CHECK(find_stored_states(directory.file("nowhere/a.rsout"), unusable).empty());
}

TEST_CASE("overlay count overwrites, cycle count begins anew", "[io][restart]") {
  CHECK(slots({0, std::nullopt}, 4) == std::vector<std::int64_t>{1, 2, 3, 4});
  CHECK(slots({2, std::nullopt}, 7) == std::vector<std::int64_t>{1, 1, 1, 2, 2, 2, 3});
  CHECK(slots({0, 3}, 7) == std::vector<std::int64_t>{1, 2, 3, 1, 2, 3, 1});
  CHECK(slots({1, 2}, 6) == std::vector<std::int64_t>{1, 1, 2, 2, 1, 1});
}
