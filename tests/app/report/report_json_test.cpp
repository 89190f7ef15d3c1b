// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_json.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/unpacked_numbers.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

nlohmann::json json_of(const ReportRun& run) {
  return nlohmann::json::parse(format_report_json(run, 1'000'000));
}

/// A cube beside a sphere of radius 0.5, without results.
ReportRun drawn_run() {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .name = "cube"}).add_spheres(2, "grain", {{0, 0, 4}}).set_element_ids({70, 80});
  auto made = std::make_unique<ReportMesh>();
  made->mesh = builder.build();
  made->geometry = make_report_geometry(made->mesh, std::nullopt, {});
  made->geometry.radii[1] = 0.5;
  ReportRun run;
  run.mesh = std::move(made);
  return run;
}

}  // namespace

TEST_CASE("a run of which nothing is known is null but for its lists", "[app][report]") {
  const auto json = json_of({});
  CHECK(json["name"] == "");
  CHECK(json["summary"].is_null());
  CHECK(json["surfaces"].is_null());
  CHECK(json["mesh"].is_null());
  CHECK(json["frames"].is_null());
  CHECK(json["notes"] == nlohmann::json::array());
  CHECK(json["problems"] == nlohmann::json::array());
  CHECK(json["deck"]["files"] == nlohmann::json::array());
}

TEST_CASE("a summary and a table stand in a report as they are, broken ones do not", "[app][report]") {
  ReportRun run;
  run.summary = R"({"run": {"steps": 3}})";
  run.surfaces = "{\"cut off";
  const auto json = json_of(run);
  CHECK(json["summary"]["run"]["steps"] == 3);
  CHECK(json["surfaces"].is_null());
}

TEST_CASE("problems of a report have all their places, as far as they are known", "[app][report]") {
  const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", "x\ny\n"});
  DeckLocation place;
  place.file = file;
  place.line = 1;
  place.column = 2;
  ReportRun run;
  run.found.add_warning("odd", place, "strange", "look");
  place.line = 2;
  run.found.add_warning("odd", place, "strange", "look");
  run.found.add_error({}, "lost");
  const auto problems = json_of(run)["problems"];
  REQUIRE(problems.size() == 2);
  CHECK(problems[0]["severity"] == "warning");
  CHECK(problems[0]["id"] == "odd");
  CHECK(problems[0]["hint"] == "look");
  REQUIRE(problems[0]["places"].size() == 2);
  CHECK(problems[0]["places"][1] == nlohmann::json{{"file", "a.i"}, {"line", 2}, {"column", 2}});
  CHECK(problems[1]["severity"] == "error");
  CHECK(problems[1]["places"].empty());
}

TEST_CASE("curves are rounded to six digits, what is not finite is null, and the smallest numbers are there",
          "[app][report]") {
  ReportRun run;
  const double infinity = std::numeric_limits<double>::infinity();
  run.charts = {{"Energies",
                 "a.csv",
                 "energy",
                 {0.0, 1.0 / 3.0},
                 {{"kinetic", {1234567.0, infinity}},
                  {"friction", {1e-310, std::numeric_limits<double>::denorm_min()}},
                  {"lost", {std::nan(""), -std::numeric_limits<double>::max()}}}}};
  const auto chart = json_of(run)["charts"][0];
  CHECK(chart["title"] == "Energies");
  CHECK(chart["source"] == "a.csv");
  CHECK(chart["times"] == nlohmann::json{0.0, 0.333333});
  CHECK(chart["curves"][0]["values"] == nlohmann::json{1234570.0, nullptr});
  CHECK(chart["curves"][1]["values"][0].get<double>() == Approx(0.0).margin(1e-300));
  CHECK(chart["curves"][2]["values"][0].is_null());
  CHECK(chart["curves"][2]["values"][1] == -1.79769e308);
}

TEST_CASE("no text of a report ends its script early, and none is no UTF-8", "[app][report]") {
  ReportRun run;
  run.name = "</script>";
  run.notes = {"a < b", "\xff"};
  const std::string text = format_report_json(run, 1000);
  CHECK(text.find('<') == std::string::npos);
  const auto json = nlohmann::json::parse(text);
  CHECK(json["name"] == "</script>");
  CHECK(json["notes"][0] == "a < b");
  CHECK(json["notes"][1] == "\xef\xbf\xbd");
}

TEST_CASE("a mesh is drawn by its faces, blocks and coordinates", "[app][report]") {
  const auto json = json_of(drawn_run())["mesh"];
  CHECK(json["nodes"] == 9);
  CHECK(json["elements"] == 2);
  CHECK(json["points"] == 9);
  CHECK(json["blocks"][0]["shape"] == "HEX8");
  CHECK(json["blocks"][0]["radius"].is_null());
  CHECK(json["blocks"][1]["radius"] == 0.5);
  CHECK(json["faces"]["n"] == 6);
  CHECK_FALSE(json["faces"].contains("shown_from"));
  CHECK(unpack_numbers(json["faces"]["element"], 6, false) == std::vector<std::int64_t>(6, 70));
  CHECK(unpack_numbers(json["particles"]["element"], 1, false) == std::vector<std::int64_t>{80});
  CHECK(json["lines"]["n"] == 0);
  const auto& heights = json["coordinates"][2];
  CHECK(heights["first"] == 0.0);
  CHECK(heights["first"].get<double>() + 65535.0 * heights["step"].get<double>() == Approx(4.0));
}

TEST_CASE("sentences on what a mesh lacks are notes, behind those of the run", "[app][report]") {
  MeshBuilder builder;
  builder.add_hexes({.id = 1});
  auto made = std::make_unique<ReportMesh>();
  made->mesh = builder.build();
  made->geometry = make_report_geometry(made->mesh, std::nullopt, {});
  made->fields.not_found = {"There is no displacement."};
  made->fields.left_out = {"a", "b"};
  ReportRun run;
  run.notes = {"First."};
  run.mesh = std::move(made);
  CHECK(json_of(run)["notes"] ==
        nlohmann::json{"First.", "There is no displacement.", "Stored variables that are not shown: a, b."});
}
