// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/run_report.hpp"

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::ProgramDirectory;
using Json = nlohmann::json;

namespace {

Json data_of(const std::string& page) {
  const std::string head = "id=\"report-data\">";
  const std::size_t begin = page.find(head);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find("</script>", begin);
  return Json::parse(page.substr(begin + head.size(), end - begin - head.size()));
}

/// decks/impact.i for a twentieth of its time.
struct ShortImpact : ProgramDirectory {
  ShortImpact() {
    copy_decks({"impact.i", "impact.g"});
    edit("impact.i", "termination time = 120e-6", "termination time = 6e-6");
  }
};

std::string titles_of(const Json& run) {
  std::string titles;
  for (const Json& chart : run["charts"]) titles += chart["title"].get<std::string>() + ";";
  return titles;
}

}  // namespace

TEST_CASE("a run writes a page of itself", "[app][report]") {
  const ShortImpact directory;
  const auto [code, out, err] = directory.run({"impact.i", "--report", "r.html"});
  REQUIRE(code == 0);
  const Json run = data_of(directory.read("r.html"))["runs"][0];
  CHECK(run["title"] == "ball on plate");
  CHECK(run["name"] == "impact.e");
  CHECK(run["summary"]["state"] == "done");
  CHECK(run["surfaces"]["surfaces"].size() == 3);
  CHECK(run["deck"]["files"][0]["text"] == directory.read("impact.i"));
  CHECK(run["problems"][0]["places"][0]["line"] == 78);
  CHECK(run["mesh"]["faces"]["n"] == 1600 + 216);
  CHECK(run["mesh"]["owners"] == Json({"patch", "plate", "ball"}));
  CHECK(run["frames"]["times"].size() == 3);
  CHECK(run["frames"]["fields"][0]["name"] == "pressure");
  CHECK(run["frames"]["fields"][1]["name"] == "von_mises");
  CHECK(titles_of(run) ==
        "Energies;Contact force of pairs;Deepest penetration of pairs;Energies;error;force;momentum;");
  const double peak = run["summary"]["pairs"][2]["peak_force"];
  double largest = 0.0;
  for (const double force : run["charts"][1]["curves"][0]["values"]) largest = std::max(largest, force);
  CHECK(largest == Approx(peak).epsilon(1e-5));
  CHECK(run["notes"].empty());
}

TEST_CASE("a page is made of results and what lies beside them", "[app][report]") {
  const ShortImpact directory;
  REQUIRE(directory.run({"impact.i", "--summary", "impact.json"}).exit_code == 0);
  const auto [code, out, err] = directory.run({"report", "impact.e"});
  REQUIRE(code == 0);
  CHECK_THAT(out, Contains("impact.html, ") && Contains(" bytes"));
  const Json run = data_of(directory.read("impact.html"))["runs"][0];
  CHECK(run["title"] == "ball on plate");
  CHECK(run["summary"]["state"] == "done");
  CHECK(run["surfaces"]["surfaces"][0]["name"] == "patch");
  CHECK(run["mesh"]["knows_claims"] == true);
  CHECK(run["deck"]["expanded"] == true);
  CHECK_THAT(run["deck"]["files"][0]["text"].get<std::string>(),
             Contains("\n        skin all blocks = on\n"));
  CHECK_THAT(titles_of(run), Contains("Energies") && Contains("force"));

  const auto chosen = directory.run({"report", "--deck", "impact.i", "--heartbeat", "impact.csv",
                                     "--heartbeat", "impact.csv", "impact.e", "-o", "own.html"});
  CHECK(chosen.exit_code == 0);
  const Json own = data_of(directory.read("own.html"))["runs"][0];
  CHECK(own["deck"]["files"][0]["name"] == "impact.i");
  CHECK(own["charts"].size() == run["charts"].size() + 4);  // of the second heartbeat

  CHECK(directory.run({"report", "impact.e", "impact.e", "-o", "two.html"}).exit_code == 0);
  CHECK(data_of(directory.read("two.html"))["runs"].size() == 2);
  const auto plain = directory.run({"report", "impact.g", "-o", "mesh.html"});
  CHECK(plain.exit_code == 0);
  const Json mesh = data_of(directory.read("mesh.html"))["runs"][0];
  CHECK_THAT(mesh["notes"][0].get<std::string>(), Contains("The results hold no deck"));
  CHECK_THAT(mesh["notes"][1].get<std::string>(), Contains("No results over time"));
  CHECK(mesh["mesh"]["faces"]["n"] == 1600 + 216);
}

TEST_CASE("a run that does not get to its end writes its page all the same", "[app][report]") {
  const ShortImpact directory;
  directory.write("wrong.i", "begin sierra\n  bogus = 3\nend\n");
  CHECK(directory.run({"wrong.i", "--report", "w.html"}).exit_code == 2);
  const Json wrong = data_of(directory.read("w.html"))["runs"][0];
  CHECK(wrong["summary"]["state"] == "failed");
  CHECK(wrong["problems"][0]["severity"] == "error");
  CHECK(wrong["problems"][0]["places"][0]["line"] == 2);
  CHECK(wrong["mesh"].is_null());

  CHECK(directory.run({"impact.i", "none.g", "--report", "n.html"}).exit_code == 3);
  CHECK_THAT(data_of(directory.read("n.html"))["runs"][0]["problems"][0]["text"].get<std::string>(),
             Contains("none.g"));

  const auto stopped = directory.run_and_signal({"impact.i", "--report", "s.html"}, "impact.e", SIGTERM);
  const Json run = data_of(directory.read("s.html"))["runs"][0];
  CHECK(run["summary"]["state"] == (stopped.exit_code == 5 ? "stopped" : "done"));
  CHECK(run["frames"]["times"].size() >= 1);
}

TEST_CASE("curves of a long run are thinned out and reach its end", "[app][report]") {
  const test::TwoBlocks directory;
  directory.edit("two_blocks.i", "termination time = 1e-3", "termination time = 0.25");
  directory.edit("two_blocks.i", "increment = 1e-4", "increment = 0.1");
  REQUIRE(directory.run({"two_blocks.i", "--report", "r.html"}).exit_code == 0);
  const Json run = data_of(directory.read("r.html"))["runs"][0];
  REQUIRE(run["summary"]["run"]["steps"] > 2000);
  const auto times = run["charts"][0]["times"].get<std::vector<double>>();
  CHECK(times.size() > 500);
  CHECK(times.size() <= 1000);
  CHECK(std::ranges::is_sorted(times));
  CHECK(times.front() == 0.0);
  CHECK(times.back() == Approx(run["summary"]["run"]["time"].get<double>()));
}

TEST_CASE("a check writes a page of the surfaces", "[app][report]") {
  const test::TwoBlocks directory;
  REQUIRE(directory.run({"two_blocks.i", "--check", "-D", "order=2", "--report", "c.html"}).exit_code == 0);
  const Json run = data_of(directory.read("c.html"))["runs"][0];
  CHECK(run["mesh"]["owners"] == Json({"left", "right", "cladding", "top"}));
  CHECK(run["mesh"]["lost"].size() == 3);
  CHECK(run["frames"]["times"].empty());
}

TEST_CASE("what a page cannot be made of or replace is refused by name", "[app][report]") {
  const ShortImpact directory;
  CHECK(directory.run({"report", "none.e"}).exit_code == 3);
  CHECK(directory.run({"report"}).exit_code == 2);
  CHECK(directory.run({"report", "impact.g", "impact.g", "--deck", "impact.i"}).exit_code == 2);
  const auto summary = directory.run({"report", "impact.g", "--summary", "impact.i"});
  CHECK(summary.exit_code == 3);
  CHECK_THAT(summary.err, Contains("expected a summary (JSON of --summary), found a deck"));
  const auto mesh = directory.run({"report", "impact.g", "-o", "impact.i"});
  CHECK(mesh.exit_code == 3);
  CHECK_THAT(mesh.err, Contains("impact.i: the report would overwrite a file that is no HTML"));
  CHECK(directory.run({"impact.i", "--report", "impact.i"}).exit_code == 2);
}
