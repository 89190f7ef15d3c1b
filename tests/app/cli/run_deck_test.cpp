// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_deck.hpp"

#include "support/catch.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;

namespace {

/// A directory with the mesh of two_blocks.i and a deck "a.i".
struct WithMesh : ProgramDirectory {
  explicit WithMesh(const std::string& deck) {
    copy_decks({"two_blocks.g"});
    write("a.i", deck);
  }
};

/// Without a pair of surfaces a deck is warned about.
const std::string self_contact = "begin interaction defaults\nself contact = on\nend\n";

/// A deck of one region for each of these lines of contact, in a procedure of its own.
std::string deck_of_regions(const std::vector<std::string>& contacts) {
  std::string deck = "begin sierra\nbegin finite element model m\n  database name = two_blocks.g\nend\n";
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    deck += "begin presto procedure p" + n + "\nbegin time control\nbegin time stepping block b\n" +
            "start time = 0\nend\ntermination time = 1\nend\n" + "begin presto region r" + n +
            "\nuse finite element model m\n" + contacts[i] + "end\nend\n";
  }
  return deck + "end\n";
}

}  // namespace

TEST_CASE("a parse with --parse needs no mesh and resolves no surfaces", "[app][simulation]") {
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.i"});
  const auto [code, out, err] = directory.run({"two_blocks.i", "--parse"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("1 material, 1 section, 0 functions, 1 procedure, 1 region with contact") &&
                      !Contains("Mesh") && !Contains("Contact surfaces"));
  CHECK(err == "");
}

TEST_CASE("all errors of a deck appear in one run, in the order of its lines", "[app][simulation]") {
  const ProgramDirectory directory;
  directory.write("a.i",
                  "begin sierra\n"
                  "  begin finite element model m\n"
                  "    database nam = x.g\n"
                  "    begin parameters for block b\n"
                  "      material = steel\n"
                  "    end\n"
                  "  end\n"
                  "  begin presto procedure p\n"
                  "    begin time control\n"
                  "      begin time stepping block t\n"
                  "        start time = soon\n"
                  "      end\n"
                  "      termination time = 1\n"
                  "    end\n"
                  "    begin presto region r\n"
                  "      use finite element model n\n"
                  "    end\n"
                  "  end\n"
                  "end\n");
  const auto [code, out, err] = directory.run({"a.i", "--parse"});
  CHECK(code == 2);
  CHECK(err ==
        "a.i:3:5: error: unknown command 'database nam = x.g' in 'finite element model m'; did you mean "
        "'database name'?\n"
        "a.i:11:22: error: expected a number for 'start time', found 'soon'\n"
        "a.i:16:32: error: unknown finite element model 'n'; did you mean 'm'?\n"
        "contactsim: 3 errors\n");
}

TEST_CASE("wrong names of mesh parts appear together with the deck's other errors", "[app][simulation]") {
  const WithMesh directory(
      "contact surface a contains lefft\n"
      "contact surface b contanes right\n"
      "contact surface c contains patch rigth\n");
  const auto [code, out, err] = directory.run({"a.i", "two_blocks.g", "--check"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("a.i:1:28: error: ") && Contains("'lefft'") && Contains("'left'") &&
                      Contains("a.i:2:19: error: ") && Contains("a.i:3:34: error: ") && Contains("'right'") &&
                      Contains("contactsim: 3 errors\n"));
  CHECK(err.find("a.i:1:") < err.find("a.i:2:"));
  CHECK(err.find("a.i:2:") < err.find("a.i:3:"));
}

TEST_CASE("wrong names of mesh parts end a run with code 2", "[app][simulation]") {
  const WithMesh directory("contact surface a contains lefft\n");
  const auto [code, out, err] = directory.run({"a.i", "two_blocks.g", "--check"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("a.i:1:28: error: ") && Contains("contactsim: 1 error\n"));
}

TEST_CASE("a --lenient run passes over unknown commands with a warning", "[app][simulation]") {
  const WithMesh directory("begin contact definition\n  frobnicate = 3\n  contact surface a contains left\n" +
                           self_contact + "end\n");
  CHECK(directory.run({"a.i", "two_blocks.g", "--check"}).exit_code == 2);
  const auto [code, out, err] = directory.run({"a.i", "two_blocks.g", "--check", "--lenient"});
  CHECK(code == 0);
  CHECK(err ==
        "a.i:2:3: warning: unknown command 'frobnicate = 3' in 'contact definition', passed over "
        "[deck-unknown]\n");
  CHECK_THAT(out, Contains("\n1 warning\n"));
}

TEST_CASE("a -D sets a number or a string for the deck", "[app][simulation]") {
  const WithMesh directory(
      "{if(n == 2 && part == \"right\")}\ncontact surface s{n} contains {part}\n{endif}\n" + self_contact);
  const auto [code, out, err] =
      directory.run({"a.i", "two_blocks.g", "--check", "-D", "n=2", "-D", "part=right"});
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, Contains("   1  s2 "));
}

TEST_CASE("a -D that is not name=value ends with code 2", "[app][simulation]") {
  const WithMesh directory("contact surface a contains left\n");
  const std::string wrong = GENERATE("x", "=3", "bad name=3", "3x=1", "");
  const auto [code, out, err] = directory.run({"a.i", "--parse", "-D", wrong});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("error: -D " + wrong) && Contains("name=value"));
}

TEST_CASE("a -D that the deck does not use is an error", "[app][simulation]") {
  const WithMesh directory("# {width = 2}\ncontact surface a contains left\n");
  const auto [code, out, err] = directory.run({"a.i", "--parse", "-D", "widht=3"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("error: the deck does not use 'widht' of -D; did you mean 'width'?"));
}

TEST_CASE("an output file that cannot be written ends with code 3 and keeps the others",
          "[app][simulation]") {
  const WithMesh directory("skin all blocks = on\n");
  directory.write("whole.csv", "of an earlier run\n");
  const std::string missing = GENERATE("--surfaces-json", "--surfaces");
  const auto [code, out, err] = directory.run(
      {"a.i", "two_blocks.g", "--check", missing, "no/such/file", "--surfaces-csv", "whole.csv"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("error: no/such/file"));
  CHECK(directory.read("whole.csv").starts_with("surface,block,element,side,kind,area\n"));
  CHECK_THAT(directory.read("a.log"), Contains("\nContact surfaces\n") && Contains("error: no/such/file"));
}

TEST_CASE("a run that fails leaves the files of an earlier run as they are", "[app][simulation]") {
  const WithMesh directory("contact surface a contains nothing_there\n");
  for (const char* name : {"s.json", "s.csv", "s.exo"}) directory.write(name, "earlier");
  const auto [code, out, err] = directory.run({"a.i", "two_blocks.g", "--check", "--surfaces-json", "s.json",
                                               "--surfaces-csv", "s.csv", "--surfaces", "s.exo"});
  CHECK(code == 2);
  for (const char* name : {"s.json", "s.csv", "s.exo"}) CHECK(directory.read(name) == "earlier");
  CHECK(directory.list() ==
        std::vector<std::string>{"a.i", "a.log", "s.csv", "s.exo", "s.json", "two_blocks.g"});
}

TEST_CASE("nothing unfinished is left beside the files of a run", "[app][simulation]") {
  const WithMesh directory("skin all blocks = on\n");
  directory.run({"a.i", "two_blocks.g", "--check", "--surfaces-json", "s.json", "--surfaces-csv", "s.csv",
                 "--surfaces", "s.exo"});
  CHECK(directory.list() ==
        std::vector<std::string>{"a.i", "a.log", "s.csv", "s.exo", "s.json", "two_blocks.g"});
}

TEST_CASE("a deck without contact writes empty tables", "[app][simulation]") {
  const WithMesh directory(deck_of_regions({""}));
  const auto [code, out, err] = directory.run(
      {"a.i", "--tables", "--surfaces-json", "s.json", "--surfaces-csv", "s.csv", "--surfaces", "s.exo"});
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, Contains("\nThe deck has no contact definition.\n"));
  CHECK_THAT(directory.read("s.json"), Contains("\"surfaces\": []"));
  CHECK(directory.read("s.csv") == "surface,block,element,side,kind,area\n");
  CHECK(directory.has("s.exo"));
}

TEST_CASE("a run without contact writes the tables that are asked for", "[app][simulation]") {
  const contactsim::test::TwoBlocks directory;
  std::string deck = directory.read("two_blocks.i");
  const auto begin = deck.find("      begin contact definition");
  deck.erase(begin, deck.find("      begin results output") - begin);
  directory.write("a.i", deck);
  const auto [code, out, err] =
      directory.run({"a.i", "--surfaces-json", "s.json", "--surfaces-csv", "s.csv"});
  CHECK(code == 0);
  CHECK_THAT(directory.read("s.json"), Contains("\"surfaces\": []"));
  CHECK(directory.read("s.csv") == "surface,block,element,side,kind,area\n");
}

TEST_CASE("a deck whose procedure another block has swallowed is refused at its first line",
          "[app][simulation]") {
  std::string deck = deck_of_regions({""});
  deck.insert(deck.find("begin presto procedure"), "begin material unused\n");
  const auto [code, out, err] = WithMesh(deck + "end\n").run({"a.i", "two_blocks.g"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("a.i:1:") && Contains("error: the deck has no procedure"));
  deck = deck_of_regions({""});
  deck.erase(deck.find("end\nbegin presto region"), 4);
  const auto without_region = WithMesh(deck + "end\n").run({"a.i", "two_blocks.g", "--lenient"});
  CHECK(without_region.exit_code == 2);
  CHECK_THAT(without_region.err, Contains("error: the procedure has no region"));
}

TEST_CASE("the regions of all procedures are resolved, files of surfaces hold the first",
          "[app][simulation]") {
  const WithMesh directory(deck_of_regions(
      {"begin contact definition\ncontact surface one contains left\n" + self_contact + "end\n",
       "begin contact definition\ncontact surface two contains right\nend\n"}));
  const auto [code, out, err] = directory.run({"a.i", "--tables", "--surfaces-csv", "s.csv"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("\nProcedure p1: ") && Contains("   1  one ") && Contains("\nProcedure p2: ") &&
                      Contains("   1  two "));
  CHECK_THAT(err,
             Contains("warning: the files of surfaces do not hold those of the procedure 'p2'; they hold "
                      "those of 'p1' [deck-region]\n"));
  CHECK_THAT(directory.read("s.csv"), Contains("\none,") && !Contains("\ntwo,"));
}
