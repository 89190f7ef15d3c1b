// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/report_file.hpp"

#include <nlohmann/json.hpp>

#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "io/files/write_text.hpp"
#include "support/catch.hpp"
#include "support/staged_deck.hpp"
#include "support/two_cube_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

namespace {

/// The report r.html of a run of two cubes; its libraries are words that stand for them.
struct ReportedDeck : StagedDeck {
  ReportedDeck() : StagedDeck(two_cube_mesh(0.1).build(), two_cube_deck(text_of({}))) {
    options.report = file("r.html");
    draft.deck = {{"d.i", "begin sierra\nend\n"}};
  }
  void take_region() {
    draft.definition = definition;
    draft.region = definition.procedures.front().regions.front();
    draft.has_mesh = true;
  }
  Json write() {
    write_report_file(options, draft, summary, {"library_three", "library_controls", "library_chart"});
    page = read_bytes(file("r.html"));
    const std::string head = "id=\"report-data\">";
    const std::size_t begin = page.find(head) + head.size();
    return Json::parse(page.substr(begin, page.find("</script>", begin) - begin))["runs"][0];
  }
  std::string page;
};

}  // namespace

TEST_CASE("libraries are read where a report is asked for that can be written", "[app][report]") {
  ReportedDeck deck;
  deck.options.report.reset();
  CHECK_FALSE(find_report_libraries(deck.options));
  deck.options.report = deck.file("no/r.html");
  CHECK_THROWS_AS(find_report_libraries(deck.options), FileError);
  write_text(deck.file("notes.txt"), "keep me\n");
  deck.options.report = deck.file("notes.txt");
  CHECK_THROWS_WITH(find_report_libraries(deck.options), Contains("notes.txt") && Contains("no HTML"));
}

TEST_CASE("the report of a deck that went no further has its text, problems and libraries", "[app][report]") {
  ReportedDeck deck;
  deck.summary.found.add_warning("w", {}, "a warning");
  deck.summary.error_lines = {"error: m.g: cannot be read", "a bug of ours"};
  const Json run = deck.write();
  CHECK_THAT(deck.page,
             Contains("library_three") && Contains("library_controls") && Contains("library_chart"));
  CHECK(run["name"] == "d.i");
  CHECK(run["deck"]["files"][0]["text"] == "begin sierra\nend\n");
  CHECK(run["mesh"].is_null());
  std::vector<std::string> problems;
  for (const Json& problem : run["problems"]) problems.push_back(problem["text"]);
  std::ranges::sort(problems);
  CHECK(problems == std::vector<std::string>{"a bug of ours", "a warning", "m.g: cannot be read"});
}

TEST_CASE("a run without results shows its mesh as it was read, and says so", "[app][report]") {
  const bool is_run = GENERATE(false, true);
  ReportedDeck deck;
  deck.take_region();
  deck.options.stage = is_run ? Stage::run : Stage::check;
  const Json run = deck.write();
  CHECK(run["mesh"]["faces"]["n"] == 24 + 6);
  std::size_t n_told = 0;
  for (const Json& note : run["notes"])
    n_told += note.get<std::string>().find("BEGIN RESULTS OUTPUT") != std::string::npos ? 1 : 0;
  CHECK(n_told == (is_run ? 1 : 0));
  ReportedDeck without;
  without.take_region();
  without.draft.has_mesh = false;
  CHECK(without.write()["mesh"].is_null());
}

TEST_CASE("of the outputs the first with a mesh is shown, and heartbeats as charts", "[app][report]") {
  ReportedDeck deck;
  deck.take_region();
  write_exodus(deck.file("out.e"), two_cube_mesh(0.5).build());
  write_text(deck.file("h.csv"), "time,force\n0,1\n0.5,2\n");
  write_text(deck.file("h.txt"), "time force\n0 1\n");
  deck.draft.output_paths = {deck.file("h.csv"), deck.file("h.txt"), deck.file("none.e"), deck.file("out.e")};
  const Json run = deck.write();
  CHECK(run["name"] == deck.file("out.e"));
  REQUIRE(run["charts"].size() >= 1);
  CHECK(run["charts"].back()["title"] == "force");
  CHECK(run["charts"].back()["curves"][0]["values"] == Json({1.0, 2.0}));
}
