// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_diff.hpp"

#include <chrono>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using contactsim::test::TwoBlocks;

namespace {

/// The tables of decks/two_blocks.i with the patch named first (1) and last (2).
struct Tables : TwoBlocks {
  Tables() {
    for (const std::string order : {"1", "2"})
      run({"two_blocks.i", "--check", "-D", "order=" + order, "--surfaces-json", order + ".json",
           "--surfaces-csv", order + ".csv", "--summary", "summary" + order + ".json"});
  }
};

}  // namespace

TEST_CASE("the same tables end a diff with code 0", "[app][diff]") {
  const Tables directory;
  for (const std::string name : {"1.json", "1.csv", "summary1.json"}) {
    const auto [code, out, err] = directory.run({"diff", name, name});
    CHECK(code == 0);
    CHECK_THAT(out, Contains("no differences"));
    CHECK(err == "");
  }
}

TEST_CASE("a diff of two orders says which facets moved, by lists and by tables", "[app][diff]") {
  const Tables directory;
  const auto lists = directory.run({"diff", "1.csv", "2.csv"});
  CHECK(lists.exit_code == 1);
  CHECK(lists.out ==
        "ownership: 3 differences\n"
        "  first   1.csv\n"
        "  second  2.csv\n"
        "  only in the first: surface 'top'\n"
        "  moved: 4 facets from 'top' to 'left', area 4\n"
        "  moved: 4 facets from 'top' to 'right', area 4\n");
  const auto tables = directory.run({"diff", "1.json", "2.json"});
  CHECK(tables.exit_code == 1);
  CHECK_THAT(tables.out, Contains("moved: 4 facets from 'top' to 'left'\n") &&
                             Contains("moved: 4 facets from 'top' to 'right'\n") &&
                             Contains("order: top, left, right, cladding -> left, right, cladding, top\n"));
}

TEST_CASE("two decks are compared on a mesh without a run", "[app][diff]") {
  const Tables directory;
  const auto files = directory.list();
  const auto [code, out, err] = directory.run(
      {"diff", "two_blocks.i", "two_blocks.i", "two_blocks.g", "--define-second", "order=2", "--faces"});
  CHECK(code == 1);
  CHECK_THAT(out,
             Contains("moved: 4 facets from 'top' to 'left', area 4\n") && Contains("face: block 'left'"));
  CHECK(directory.run({"diff", "two_blocks.i", "two_blocks.i"}).exit_code == 0);
  CHECK(directory.list() == files);
}

TEST_CASE("a diff of decks that are wrong says where", "[app][diff]") {
  const Tables directory;
  directory.write("wrong.i", "begin sierra\n  bogus = 3\nend\n");
  const auto [code, out, err] = directory.run({"diff", "two_blocks.i", "wrong.i", "two_blocks.g"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("wrong.i:2:3: error: unknown command"));
}

TEST_CASE("a diff of summaries names values, both, and their difference", "[app][diff]") {
  const Tables directory;
  const auto [code, out, err] = directory.run({"diff", "summary1.json", "summary2.json"});
  CHECK(code == 1);
  CHECK_THAT(out, Contains("  definitions.order: '1' -> '2'\n") &&
                      Contains("  warning surface-empty: 'absent' -> 1\n"));
}

TEST_CASE("a diff as JSON says the same", "[app][diff]") {
  const Tables directory;
  const auto run = directory.run({"diff", "1.csv", "2.csv", "--json"});
  CHECK(run.exit_code == 1);
  const auto json = nlohmann::json::parse(run.out);
  CHECK(json["schema"] == "contactsim-diff/1");
  CHECK(json["differences"][1] ==
        nlohmann::json{{"kind", "moved"}, {"from", "top"}, {"to", "left"}, {"facets", 4}, {"area", 4.0}});
}

TEST_CASE("files that a diff cannot read end it with code 2 and a reason", "[app][diff]") {
  const Tables directory;
  directory.write("empty", "");
  directory.write("half.json", directory.read("1.json").substr(0, 900));
  directory.write("other.json", "{\"a\": 1}");
  directory.write("odd.csv", "surface,block,element,side,kind,area\na,b,1\n");
  directory.write("hollow.json", "{\"schema\": \"contactsim-surfaces/1\"}");
  directory.write("note.txt", "hello\n");
  struct Mistake {
    std::vector<std::string> arguments;
    std::string said;
  };
  const auto [arguments, said] = GENERATE(values<Mistake>({
      {{"none.json", "1.json"}, "none.json: cannot be read (No such file or directory)"},
      {{"empty", "1.json"}, "empty: the file is empty"},
      {{"1.json", "half.json"}, "half.json: no whole JSON, wrong at byte 901 of 900"},
      {{"1.json", "other.json"}, "other.json: JSON without a schema of contactsim"},
      {{"1.json", "hollow.json"}, "hollow.json: no ownership table"},
      {{"1.csv", "odd.csv"}, "odd.csv: line 2: 3 fields in place of 6"},
      {{"1.csv", "note.txt"}, "note.txt: neither a table of surfaces"},
      {{"1.csv", "."}, ".: this is a directory"},
      {{"1.json", "summary1.json"},
       "summary1.json: this is a summary (JSON of --summary), but 1.json is an "
       "ownership table (JSON of --surfaces-json)"},
      {{"1.json", "1.csv"}, "1.csv: this is a list of facets"},
      {{"1.json", "2.json", "--faces"}, "--faces needs lists of facets"},
      {{"1.csv", "2.csv", "two_blocks.g"}, "two_blocks.g: a mesh is for two decks"},
      {{"1.csv"}, "B is required"},
      {{"1.csv", "2.csv", "--rtol", "-1"}, "--rtol"},
  }));
  std::vector<std::string> line{"diff"};
  line.insert(line.end(), arguments.begin(), arguments.end());
  const auto [code, out, err] = directory.run(line);
  CHECK(code == 2);
  CHECK(out == "");
  CHECK_THAT(err, Contains(said));
}

TEST_CASE("lists of 100,000 facets are compared within two seconds", "[app][diff]") {
  const ProgramDirectory directory;
  std::string first = "surface,block,element,side,kind,area\n", second = first;
  for (int i = 0; i < 100000; ++i) {
    const std::string row = ",block," + std::to_string(i) + ",3,face,0.125\n";
    first += "surface_" + std::to_string(i % 40) + row;
    second += "surface_" + std::to_string(i % 1000 == 0 ? 7 : i % 40) + row;
  }
  directory.write("a.csv", first);
  directory.write("b.csv", second);
  const auto begun = std::chrono::steady_clock::now();
  const auto [code, out, err] = directory.run({"diff", "a.csv", "b.csv"});
  CHECK(std::chrono::steady_clock::now() - begun < std::chrono::seconds(2));
  CHECK(code == 1);
  CHECK_THAT(out, Contains("moved: 100 facets from 'surface_0' to 'surface_7', area 12.5\n"));
}
