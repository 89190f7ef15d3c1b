// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_log.hpp"

#include <sstream>

#include "support/catch.hpp"
#include "support/flying_cube.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// A quiet log in a folder of its own that a run is reported to.
struct LoggedRun {
  explicit LoggedRun(FlyingCube& cube)
      : simulation(cube.simulation), log(directory.file("a.log"), true), run_log(log) {
    log.begin(false);
    simulation.observe([this](RunEvent event, const Simulation& run) { run_log.look(event, run); });
  }
  std::string text() const { return read_bytes(directory.file("a.log")); }
  /// Numbers of the steps that have a line.
  std::vector<std::string> steps() const {
    std::vector<std::string> numbers;
    std::istringstream lines(text());
    for (std::string line; std::getline(lines, line) && !line.starts_with("Energy balance");) {
      std::istringstream words(line);
      std::string first;
      const bool is_of_step =
          line.size() > 60 && words >> first && first.find_first_not_of("0123456789") == std::string::npos;
      if (is_of_step) numbers.push_back(first);
    }
    return numbers;
  }

  Simulation& simulation;
  TemporaryDirectory directory;
  Log log;
  RunLog run_log;
};

}  // namespace

TEST_CASE("a log has the model before the steps, and balance, pairs and times behind them", "[app][log]") {
  FlyingCube cube;
  const LoggedRun logged(cube);
  cube.run_to_end();
  const std::string text = logged.text();
  std::size_t at = 0;
  for (const char* part : {"Model\n", "automatic penalty behind the faces", "Energy balance", "lower",
                           "Contact search\n", "Wall time\n"}) {
    INFO(part);
    const std::size_t next = text.find(part, at);
    REQUIRE(next != std::string::npos);
    at = next;
  }
  CHECK_THAT(text, !Contains("The run ends here") && !Contains("stopped by") && !Contains("error: "));
}

TEST_CASE("a log has a line for the start, each interval and the last step, which is written once",
          "[app][log]") {
  FlyingCube cube({.time = "step interval = 4\n"});
  const LoggedRun logged(cube);
  cube.run(6);
  CHECK(logged.steps() == std::vector<std::string>{"0", "4"});
  cube.simulation.stop("a caller");
  cube.simulation.finish();
  CHECK(logged.steps() == std::vector<std::string>{"0", "4", "6"});
  CHECK_THAT(logged.text(), Contains("stopped by a caller after step 6\n"));

  FlyingCube even({.time = "step interval = 2\n"});
  const LoggedRun of_even(even);
  even.run(4);
  even.simulation.stop("a caller");
  even.simulation.finish();
  CHECK(of_even.steps() == std::vector<std::string>{"0", "2", "4"});
}

TEST_CASE("why a run ends before its time is reported", "[app][log]") {
  FlyingCube cube({.region = "begin solution termination\nterminate global kinetic_energy < 10\nend\n"});
  const LoggedRun logged(cube);
  cube.run_to_end();
  CHECK_THAT(logged.text(), Contains("The run ends here: "));
}
