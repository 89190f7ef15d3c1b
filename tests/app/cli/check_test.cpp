// SPDX-License-Identifier: BSD-3-Clause
// What --check finds without a run, --strict and --quiet.
#include <filesystem>
#include <sstream>

#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// Two boxes that fall, a deck of its own for each test.
struct Boxes : ProgramDirectory {
  ///   more    further lines of the region
  ///   behind  further blocks behind the procedure
  explicit Boxes(const std::string& more, const std::string& behind = "") {
    MeshBuilder b;
    b.add_hexes({.id = 1, .name = "low"});
    b.add_hexes({.id = 2, .name = "high", .origin = {0, 0, 1.5}, .share_nodes = false});
    contactsim::test::write_exodus(path("a.g"), b.build());
    write("a.i",
          "begin sierra\nbegin material m\ndensity = 8000\nbegin parameters for model elastic\n"
          "youngs modulus = 2e11\npoissons ratio = 0.3\nend\nend\n"
          "begin finite element model f\nbegin parameters for block low high\nmaterial = m\nmodel = elastic\n"
          "end\nend\n" +
              procedure("p", "r", more) + behind + "end\n");
  }

  static std::string procedure(const std::string& name, const std::string& region, const std::string& more) {
    return "begin presto procedure " + name +
           "\nbegin time control\nbegin time stepping block t\nstart time = 0\n"
           "begin parameters for presto region " +
           region + "\nend\nend\ntermination time = 1e-3\nend\nbegin presto region " + region +
           "\nuse finite element model f\n" + more + "end\nend\n";
  }
};

const std::string contact =
    "begin contact definition\nskin all blocks = on\nbegin interaction defaults\ngeneral contact = "
    "on\nend\nend\n";

std::string results(const std::string& lines, const std::string& file = "a.e") {
  return "begin results output\ndatabase name = " + file + "\nat time 0 increment = 1e-4\n" + lines + "end\n";
}

}  // namespace

TEST_CASE("a check that finds nothing tells what the run takes, and leaves no results", "[app][check]") {
  const Boxes boxes(contact + results("nodal displacement\n"));
  const auto [code, out, err] = boxes.run({"a.i", "--check"});
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, Contains("A run of this deck\n  stable time step  ") && Contains(" of 2 elements: "));
  CHECK_FALSE(boxes.has("a.e"));
  // The clock is in the log alone.
  CHECK_THAT(boxes.read("a.log"), Contains("s of the clock") && Contains("MiB"));
  CHECK(boxes.run({"a.i", "--check"}).out == out);
}

namespace {

/// What a check says that a file would take [bytes]; 0 without its row.
std::uint64_t estimated_bytes(const std::string& out, const std::string& file) {
  std::istringstream lines(out);
  for (std::string line, name; std::getline(lines, line);) {
    std::istringstream words(line);
    std::uint64_t n_states = 0, n_bytes = 0;
    if (words >> name && name == file && words >> n_states >> n_bytes) return n_bytes;
  }
  return 0;
}

void check_estimate(const ProgramDirectory& directory, const std::string& deck,
                    const std::vector<std::string>& files) {
  const auto checked = directory.run({deck, "--check"});
  REQUIRE(checked.exit_code == 0);
  REQUIRE(directory.run({deck}).exit_code == 0);
  for (const std::string& file : files) {
    INFO(file);
    const auto written = static_cast<double>(directory.read(file).size());
    CHECK(static_cast<double>(estimated_bytes(checked.out, file)) == Approx(written).epsilon(0.1));
  }
}

}  // namespace

TEST_CASE("a check tells the bytes of the files of a run within a tenth", "[app][check]") {
  const Boxes boxes(contact + results("nodal displacement\nelement stress\nglobal kinetic_energy\n") +
                    "begin heartbeat output\nstream name = a.csv\nat time 0 increment = 2e-5\nlabels = on\n"
                    "global kinetic_energy\nglobal momentum\nend\n"
                    "begin history output\ndatabase name = a.h\nglobal kinetic_energy\nend\n");
  check_estimate(boxes, "a.i", {"a.e", "a.csv", "a.h"});
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.i", "two_blocks.g"});
  check_estimate(directory, "two_blocks.i", {"two_blocks.e"});
}

TEST_CASE("a check of a run that would never end is done all the same", "[app][check]") {
  const Boxes boxes(contact + results("nodal displacement\n"));
  std::string deck = boxes.read("a.i");
  const std::string end = "termination time = 1e-3";
  boxes.write("a.i", deck.replace(deck.find(end), end.size(), "termination time = 1e8"));
  const auto [code, out, err] = boxes.run({"a.i", "--check"});
  CHECK(code == 0);
  CHECK(estimated_bytes(out, "a.e") > 1'000'000'000);
}

TEST_CASE("a check finds what a run would refuse", "[app][check]") {
  const auto found = [](const std::string& more) {
    const auto [code, out, err] = Boxes(contact + more).run({"a.i", "--check"});
    CHECK(code == 2);
    CHECK_THAT(out, Contains("low"));  // the tables stand all the same
    return err;
  };
  CHECK_THAT(found("begin fixed displacement\nnode set = nothing\ncomponents = x\nend\n"),
             Contains("'nothing'"));
  CHECK_THAT(found("begin pressure\nsurface = nowhere\nfunction = sierra_constant_function_one\nend\n"),
             Contains("'nowhere'"));
  CHECK_THAT(found("begin gravity\nblock = lov\ncomponent = z\nend\n"), Contains("error: "));
}

TEST_CASE("a check warns of outputs that are not there", "[app][check]") {
  const Boxes boxes(contact + results("nodal contact_pressure\nelement von_mises\n"));
  const auto [code, out, err] = boxes.run({"a.i", "--check"});
  CHECK(code == 0);
  CHECK_THAT(err, Contains("warning: ") && Contains("contact_pressure"));
  CHECK(boxes.run({"a.i", "--check", "--strict"}).exit_code == 2);
}

TEST_CASE("a check finds files that cannot be written", "[app][check]") {
  const auto [code, out, err] = Boxes(results("nodal displacement\n", "no/such/a.e")).run({"a.i", "--check"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("no/such/a.e: there is no folder 'no/such' to write it to"));
}

TEST_CASE("a check finds what any procedure of a deck would refuse", "[app][check]") {
  const Boxes boxes(contact, Boxes::procedure("q", "s", ""));
  const auto [code, out, err] = boxes.run({"a.i", "--check"});
  CHECK(code == 0);
  CHECK_THAT(err,
             Contains("warning: the procedure 'q' starts from the mesh: it takes over nothing from 'p'"));
  CHECK_THAT(out,
             Contains("\nProcedure p: explicit, region r, time 0 to 0.001\n\nA run of this deck\n") &&
                 Contains("\nProcedure q: explicit, region s, time 0 to 0.001\n  starts from the mesh\n"));
  CHECK(Boxes(contact, Boxes::procedure("q", "s", "begin gravity\nblock = lov\ncomponent = z\nend\n"))
            .run({"a.i", "--check"})
            .exit_code == 2);
}

TEST_CASE("strict runs do not begin with a warning, and end with exit code 2", "[app][check]") {
  const Boxes boxes(contact + results("nodal contact_pressure\n"));
  const auto [code, out, err] = boxes.run({"a.i", "--strict"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("contactsim: warnings count as errors with --strict"));
  CHECK_FALSE(boxes.has("a.e"));
  CHECK(Boxes(contact).run({"a.i", "--strict"}).exit_code == 0);
  CHECK(boxes.run({"a.i", "--strict", "--lenient"}).exit_code == 2);  // both at once mean nothing
}

TEST_CASE("quiet runs print problems alone", "[app][check]") {
  const Boxes boxes(contact + results("nodal contact_pressure\n"));
  const auto loud = boxes.run({"a.i"});
  const auto [code, out, err] = boxes.run({"a.i", "-q"});
  CHECK(code == 0);
  CHECK(out == "");
  CHECK(err == loud.err);
  CHECK_THAT(boxes.read("a.log"), Contains("Energy balance"));
}

TEST_CASE("the log begins with the moment, the command and the machine", "[app][check]") {
  const Boxes boxes(contact);
  const auto [code, out, err] = boxes.run({"a.i", "--tables", "--threads", "1"});
  CHECK_THAT(boxes.read("a.log"), Contains("  date       20") && Contains("UTC\n  command    ") &&
                                      Contains(" a.i --tables --threads 1\n") && Contains(" 1 of ") &&
                                      Contains(" processors, "));
  CHECK_THAT(out, !Contains("  date  "));
}
