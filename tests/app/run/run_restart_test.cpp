// SPDX-License-Identifier: BSD-3-Clause
// Runs that store their state, go on from it, or are ended from outside.
#include "app/run/run_restart.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "app/reports/log.hpp"
#include "io/files/file_lock.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/file_modes.hpp"
#include "support/file_size_limit.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::make_programs_obey_modes;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// A directory with a bar of 4 x 2 x 2 elastic hexahedra that flies and swings.
struct FlyingBar : ProgramDirectory {
  FlyingBar() {
    contactsim::test::write_exodus(path("a.g"), MeshBuilder().add_hexes({1, "bar", {4, 2, 2}}).build());
  }
  /// Writes the deck a.i; every step and the last bits of it go to a.csv.
  ///   region    further lines of the region
  ///   sierra    further lines at the top
  ///   end_time  of the run; a step takes about 5e-5
  void write_deck(const std::string& region, const std::string& sierra, const std::string& end_time) const {
    write("a.i",
          "begin sierra\n" + sierra +
              "begin material m\ndensity = 8000\nbegin parameters for model elastic\nyoungs modulus = 200e9\n"
              "poissons ratio = 0.3\nend\nend\n"
              "begin finite element model f\nbegin parameters for block bar\nmaterial = m\nmodel = "
              "elastic\nend\nend\n"
              "begin presto procedure p\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
              "begin parameters for presto region r\nstep interval = 1000000\nend\nend\n"
              "termination time = " +
              end_time +
              "\nend\nbegin presto region r\nuse finite element model f\n"
              "begin fixed displacement\nnode = 1 2 3\ncomponents = x y z\nend\n"
              "begin initial velocity\nblock = bar\ncomponent = x\nmagnitude = 10\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "nodal coordinates at node 40 as place\nglobal energy_error as error\nend\n" +
              region + "end\nend\nend\n");
  }
  contactsim::test::ProgramOutput run_deck(const std::string& region, const std::string& sierra = "",
                                           const std::string& end_time = "2e-3") const {
    write_deck(region, sierra, end_time);
    return run({"a.i"});
  }
};

std::string restart(const std::string& lines) { return "begin restart data\n" + lines + "end\n"; }

const std::string every_ten = "at step 0 increment = 10\n";

/// As much of the end of a text as a part has.
std::string end_of(const std::string& whole, const std::string& part) {
  return whole.size() < part.size() ? "" : whole.substr(whole.size() - part.size());
}

std::string without_first_line(const std::string& text) { return text.substr(text.find('\n') + 1); }

}  // namespace

TEST_CASE("a run goes on from a stored state into files of its own", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten)).exit_code == 0);
  const std::string straight = bar.read("a.csv");
  CHECK(bar.has("a.rsout.1"));
  const auto [code, out, err] = bar.run_deck(restart(every_ten + "restart time = 1e-3\n"));
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Restart from a.rsout."));
  CHECK(bar.read("a.csv") == straight);
  const std::string rest = without_first_line(bar.read("a.csv-s0002"));
  CHECK(rest.size() > 200);
  CHECK(rest == end_of(straight, rest));
  CHECK(bar.has("a.rsout-s0002.1"));
}

TEST_CASE(
    "an automatic restart begins at the start when there is no state yet, then goes on from the last one",
    "[app][restart]") {
  const FlyingBar bar;
  const std::string automatic = "restart = automatic\n";
  const auto first = bar.run_deck(restart(every_ten), automatic, "1e-3");
  CHECK(first.exit_code == 0);
  CHECK_THAT(first.out, Contains("Restart: there is no state in a.rsout yet, the run begins at its start"));
  const auto second = bar.run_deck(restart(every_ten), automatic, "1.5e-3");
  CHECK(second.exit_code == 0);
  CHECK_THAT(second.out, Contains("Restart from a.rsout."));
  const auto third = bar.run_deck(restart(every_ten), automatic);
  CHECK_THAT(third.out, Contains("Restart from a.rsout-s0002."));
  const std::string parts = bar.read("a.csv") + without_first_line(bar.read("a.csv-s0002")) +
                            without_first_line(bar.read("a.csv-s0003"));
  const FlyingBar other;
  CHECK(other.run_deck(restart(every_ten)).exit_code == 0);
  CHECK(other.read("a.csv") == parts);
}

TEST_CASE("a damaged state is passed over for the next older one with a warning", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten)).exit_code == 0);
  std::int64_t last = 1;
  while (bar.has("a.rsout." + std::to_string(last + 1))) ++last;
  REQUIRE(last > 2);
  const std::string name = "a.rsout." + std::to_string(last), good = bar.read(name);
  bar.write(name, good.substr(0, good.size() / 2));
  const auto [code, out, err] = bar.run_deck(restart(every_ten + "restart = automatic\n"));
  CHECK(code == 0);
  CHECK_THAT(err, Contains(name + ": is damaged") && Contains("restart-file-damaged"));
  CHECK_THAT(out, Contains("Restart from a.rsout." + std::to_string(last - 1)));
  for (const std::string& file : bar.list()) {
    if (file.starts_with("a.rsout")) bar.write(file, "x");
  }
  const auto none = bar.run_deck(restart("restart = automatic\n"));
  CHECK(none.exit_code == 3);
  CHECK_THAT(none.err, Contains("none of the restart files of this name can be used"));
}

TEST_CASE("a missing state is an error for RESTART TIME unless it is optional", "[app][restart]") {
  const FlyingBar bar;
  const auto [code, out, err] = bar.run_deck(restart("restart time = 1e-3\n"));
  CHECK(code == 3);
  CHECK_THAT(err, Contains("a.rsout.1: does not exist, and RESTART TIME needs it"));
  CHECK(bar.run_deck(restart("restart time = 1e-3\noptional\n")).exit_code == 0);
}

TEST_CASE("a state of another mesh or material is refused", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten)).exit_code == 0);
  contactsim::test::write_exodus(bar.path("a.g"), MeshBuilder().add_hexes({1, "bar", {4, 2, 3}}).build());
  const auto [code, out, err] = bar.run_deck(restart("restart = automatic\n"));
  CHECK(code == 3);
  CHECK_THAT(err, Contains("is of a run with other nodes or elements"));
}

TEST_CASE("a state that is far from RESTART TIME is reported", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart("at time 0 increment = 5e-4\n")).exit_code == 0);
  CHECK_THAT(bar.run_deck(restart(every_ten + "restart time = 5e-4\n")).err, !Contains("[restart-"));
  const auto [code, out, err] = bar.run_deck(restart(every_ten + "restart time = 5e-5\n"));
  CHECK(code == 0);
  CHECK_THAT(err, Contains("no state of t = 5e-05 is stored; the nearest one, of t = ") &&
                      Contains("[restart-time]"));
}

TEST_CASE("a state of an earlier run than the latest one is reported", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart("at time 0 increment = 5e-4\n")).exit_code == 0);
  REQUIRE(bar.run_deck(restart("overlay count = 1\nat time 0 increment = 2e-3\n")).exit_code == 0);
  const auto [code, out, err] = bar.run_deck(restart(every_ten + "restart time = 1e-3\n"));
  CHECK(code == 0);
  CHECK_THAT(err, Contains("is of an earlier run than other states of a.rsout") && Contains("[restart-run]"));
}

TEST_CASE("a run that is over where it would go on says so", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten), "restart = automatic\n").exit_code == 0);
  const auto [code, out, err] = bar.run_deck(restart(every_ten), "restart = automatic\n", "1e-3");
  CHECK(code == 0);
  CHECK_THAT(err, Contains("where the run ends: nothing is left to do") && Contains("[restart-over]"));
  CHECK_THAT(bar.run_deck(restart(every_ten), "restart = automatic\n", "3e-3").err, !Contains("[restart-"));
}

TEST_CASE("a run that a condition has ended does not go beyond it", "[app][restart]") {
  const FlyingBar bar;
  const std::string ended =
      restart("at step 0 increment = 1\n") + "begin solution termination\nterminate global step >= 12\nend\n";
  REQUIRE(bar.run_deck(ended, "restart = automatic\n").exit_code == 0);
  const std::string last_line =
      bar.read("a.csv").substr(bar.read("a.csv").rfind('\n', bar.read("a.csv").size() - 2));
  const auto [code, out, err] = bar.run_deck(ended, "restart = automatic\n");
  CHECK(code == 0);
  CHECK_THAT(out, Contains("step is 12 >= 12"));
  CHECK_THAT(err, Contains("[restart-over]") && Contains("SOLUTION TERMINATION"));
  // What it writes does not go beyond the last line of the run before.
  CHECK_THAT(last_line, Contains(end_of(bar.read("a.csv-s0002"), last_line)));
}

TEST_CASE("what has changed since a state was stored is reported", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten)).exit_code == 0);
  const auto go_on_with = [&](const std::string& before, const std::string& after) {
    bar.write_deck(restart(every_ten + "restart time = 2e-3\n"), "", "2.2e-3");
    std::string deck = bar.read("a.i");
    deck.replace(deck.find(before), before.size(), after);
    bar.write("a.i", deck);
    return bar.run({"a.i"});
  };
  CHECK_THAT(go_on_with("magnitude = 10", "magnitude = 20").err, !Contains("[restart-changed]"));
  const std::string changed = "the material 'm' is not as it was in the run that stored a.rsout";
  CHECK_THAT(go_on_with("density = 8000", "density = 8001").err, Contains(changed));
  CHECK_THAT(go_on_with("youngs modulus = 200e9", "youngs modulus = 201e9").err, Contains(changed));
}

TEST_CASE("a folder in which a run is writing its log is not for another one", "[app][restart]") {
  const FlyingBar bar;
  bar.write_deck("", "", "1e-4");
  {
    const contactsim::Log running(bar.path("a.log"));
    const auto [code, out, err] = bar.run({"a.i"});
    CHECK(code == 3);
    CHECK_THAT(err, Contains("a.log") && Contains("its folder is already in use"));
    CHECK(bar.run({"a.i", "--log", "b.log"}).exit_code == 0);
  }
  CHECK(bar.run({"a.i"}).exit_code == 0);
}

TEST_CASE("results that another run is writing are left to it, whatever its log is", "[app][restart]") {
  const FlyingBar bar;
  bar.write_deck("", "", "1e-4");
  REQUIRE(bar.run({"a.i", "-o", "a.e"}).exit_code == 0);
  const std::string before = bar.read("a.e");
  {
    const FileLock running(bar.path("a.e"), "");
    const auto [code, out, err] = bar.run({"a.i", "-o", "a.e", "--log", "b.log"});
    CHECK(code == 3);
    CHECK_THAT(err, Contains("a.e: another run is writing it"));
    CHECK(bar.read("a.e") == before);
  }
  CHECK(bar.run({"a.i", "-o", "a.e"}).exit_code == 0);
}

TEST_CASE("no file is written through a link out of the folder", "[app][files]") {
  namespace fs = std::filesystem;
  const FlyingBar bar;
  bar.write_deck("", "", "1e-4");
  const contactsim::test::TemporaryDirectory elsewhere;
  const std::string kept = elsewhere.file("kept");
  contactsim::test::write_bytes(kept, "mine");
  for (const std::string name : {"a.log", "out.e"}) {
    fs::remove(bar.path(name));
    fs::create_symlink(kept, bar.path(name));
    const auto [code, out, err] = bar.run({"a.i", "-o", "out.e", "--summary", "out.json"});
    INFO(name);
    CHECK(code == 3);
    CHECK_THAT(err, Contains(name + ": is a link to '" + kept + "', outside its folder"));
    fs::remove(bar.path(name));
  }
  CHECK(contactsim::test::read_bytes(kept) == "mine");
  CHECK(bar.run({"a.i", "-o", "out.e", "--summary", "out.json"}).exit_code == 0);
}

TEST_CASE("overlay and cycle count limit the number of files", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart("at step 0 increment = 2\noverlay count = 1\ncycle count = 3\n")).exit_code ==
          0);
  CHECK(bar.has("a.rsout.3"));
  CHECK_FALSE(bar.has("a.rsout.4"));
}

TEST_CASE("restart commands that mean nothing are errors of the deck", "[app][restart]") {
  const FlyingBar bar;
  const auto none = bar.run_deck("", "restart = automatic\n");
  CHECK(none.exit_code == 2);
  CHECK_THAT(none.err, Contains("RESTART needs a BEGIN RESTART DATA in the region"));
  CHECK(bar.run_deck(restart("") + restart("")).exit_code == 2);
}

TEST_CASE("states are kept from a run from the start when the deck says OVERWRITE = OFF", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten)).exit_code == 0);
  const auto [code, out, err] = bar.run_deck(restart(every_ten + "overwrite = off\n"));
  CHECK(code == 3);
  CHECK_THAT(err, Contains("exists, and the deck says OVERWRITE = OFF"));
}

TEST_CASE("a signal ends the run after its step, and it goes on from there", "[app][restart]") {
  const int number = GENERATE(SIGTERM, SIGINT, SIGHUP);
  const FlyingBar bar;
  bar.write_deck(restart(""), "", "100");
  const auto stopped = bar.run_and_signal({"a.i"}, "a.csv", number);
  CHECK(stopped.exit_code == 5);
  CHECK_THAT(stopped.err, Contains("stopped by SIG") && Contains("after step"));
  CHECK_THAT(stopped.out, Contains("Restart: 1 state stored") && Contains("Wall time"));
  CHECK(bar.has("a.rsout.1"));
  const auto next = bar.run_deck(restart("restart = automatic\n"), "", "1e-4");
  CHECK(next.exit_code == 0);
  CHECK_THAT(next.out, Contains("Restart from a.rsout.1"));
}

TEST_CASE("a signal has a state stored without an end to the run", "[app][restart]") {
  const FlyingBar bar;
  bar.write_deck(restart(""), "", "0.5");
  CHECK(bar.run_and_signal({"a.i"}, "a.csv", SIGUSR1).exit_code == 0);
  CHECK(bar.has("a.rsout.2"));
}

TEST_CASE("without room for a state the run ends with code 3, the name of the file and whole older files",
          "[app][restart]") {
  const FlyingBar bar;
  contactsim::test::ProgramOutput full;
  {
    const contactsim::test::FileSizeLimit limit(12000);
    full = bar.run_deck(restart(every_ten));
  }
  CHECK(full.exit_code == 3);
  CHECK_THAT(full.err, Contains("a.rsout.1: cannot be written (File too large)"));
  CHECK_FALSE(bar.has("a.rsout.1.part"));
  CHECK(bar.read("a.csv").size() > 100);
}

TEST_CASE("a folder that cannot be written to and a mesh that is gone end with code 3", "[app][restart]") {
  const FlyingBar bar;
  const auto nowhere = bar.run_deck(restart(every_ten + "database name = nowhere/a.rsout\n"));
  CHECK(nowhere.exit_code == 3);
  CHECK_THAT(nowhere.err, Contains("nowhere/a.rsout.1: cannot be"));
  std::filesystem::remove(bar.path("a.g"));
  const auto gone = bar.run_deck("");
  CHECK(gone.exit_code == 3);
  CHECK_THAT(gone.err, Contains("a.g"));
}

TEST_CASE("SHIFT TO START TIME begins the run at its start time with the stored motion", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten), "", "1e-3").exit_code == 0);
  const auto [code, out, err] =
      bar.run_deck(restart(every_ten + "restart = automatic\nshift to start time\n"), "", "5e-4");
  CHECK(code == 0);
  CHECK_THAT(out, Contains("moved to the start time"));
  const FlyingBar other;
  REQUIRE(other.run_deck(restart(every_ten), "", "1.5e-3").exit_code == 0);
  const auto last_row = [](const std::string& text) {
    std::istringstream line(text.substr(text.rfind('\n', text.size() - 2) + 1));
    std::vector<double> row;
    for (std::string value; std::getline(line, value, ',');) row.push_back(std::stod(value));
    return row;
  };
  const auto shifted = last_row(bar.read("a.csv-s0002")), straight = last_row(other.read("a.csv"));
  REQUIRE(shifted.size() == straight.size());
  CHECK(shifted[0] == Approx(straight[0] - 1e-3).epsilon(0.1));
  // Between the two ends lie less than a step and its motion.
  CHECK(shifted[1] == Approx(straight[1]).margin(1e-3));
}

TEST_CASE("a run that goes on adds to the log, another one replaces it", "[app][restart]") {
  const FlyingBar bar;
  REQUIRE(bar.run_deck(restart(every_ten), "", "1e-3").exit_code == 0);
  const std::string first = bar.read("a.log");
  REQUIRE(bar.run_deck(restart(every_ten + "restart = automatic\n")).exit_code == 0);
  const std::string both = bar.read("a.log");
  CHECK(both.substr(0, first.size()) == first);
  CHECK_THAT(both.substr(first.size()), Contains("Restart from a.rsout."));
  bar.write("a.i", "begin sierra\nrestart = automatic\nnonsense\nend\n");
  CHECK(bar.run({"a.i"}).exit_code == 2);
  CHECK_THAT(bar.read("a.log"), Contains("Restart from a.rsout.") && Contains("nonsense"));
  REQUIRE(bar.run_deck(restart(every_ten), "", "1e-3").exit_code == 0);
  CHECK_THAT(bar.read("a.log"), !Contains("Restart from"));
}

TEST_CASE("MONITOR = RESTART has a line for every stored state", "[app][restart]") {
  const FlyingBar bar;
  const std::string monitor =
      "begin heartbeat output\nstream name = b.csv\nmonitor = restart\nglobal timestep as dt\nend\n";
  REQUIRE(bar.run_deck(restart(every_ten) + monitor).exit_code == 0);
  std::int64_t n_states = 0;
  while (bar.has("a.rsout." + std::to_string(n_states + 1))) ++n_states;
  const std::string text = bar.read("b.csv");
  CHECK(n_states > 2);
  CHECK(std::ranges::count(text, '\n') == n_states + 1);  // and the names
}

TEST_CASE("a folder that may not be written to ends with code 3 and the name of the file", "[app][restart]") {
  if (!make_programs_obey_modes()) {
    WARN("root may write everywhere here");
    return;
  }
  namespace fs = std::filesystem;
  const FlyingBar bar;
  fs::create_directory(bar.path("closed"));
  fs::permissions(bar.path("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  const auto check = [&](const std::string& file, const contactsim::test::ProgramOutput& output) {
    CHECK(output.exit_code == 3);
    CHECK_THAT(output.err, Contains("closed/" + file));
  };
  check("b.rsout.1", bar.run_deck(restart(every_ten + "database name = closed/b.rsout\n")));
  CHECK(bar.read("a.csv").size() > 100);
  const std::string to_csv = "begin heartbeat output\nstream name = closed/b.csv\nglobal timestep\nend\n";
  check("b.csv", bar.run_deck(to_csv));
  const std::string to_results =
      "begin results output\ndatabase name = closed/b.e\nnodal variables = velocity\nend\n";
  check("b.e", bar.run_deck(to_results));
  check("b.log", bar.run({"a.i", "--log", "closed/b.log"}));
  CHECK(fs::is_empty(bar.path("closed")));
}

TEST_CASE("a folder in the place of a file, or a full disk, ends with code 3 and the file's name",
          "[app][restart]") {
  const FlyingBar bar;
  const std::string name = GENERATE(as<std::string>{}, "a.log", "a.csv");
  if (GENERATE(true, false)) {
    std::filesystem::create_directory(bar.path(name));
  } else {
    std::filesystem::create_symlink("/dev/full", bar.path(name));
  }
  const auto [code, out, err] = bar.run_deck("");
  CHECK(code == 3);
  CHECK_THAT(err, Contains(name));
}
