// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/smoothing_report.hpp"

#include <limits>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A model of the surfaces lid and box, and a smoothing "round" with these shapes of the lid.
ContactModel smoothed_by(const SurfaceShapes& of_lid) {
  ContactModel model;
  for (const char* name : {"lid", "box"}) model.surfaces.surfaces.emplace_back().name = name;
  SmoothingShapes smoothing;
  smoothing.name = "round";
  smoothing.surfaces.resize(2);
  smoothing.surfaces[{0}] = of_lid;
  model.smoothings.push_back(std::move(smoothing));
  return model;
}

/// The only row of the table, runs of blanks made one.
std::string row_of_lid(const SurfaceShapes& of_lid) {
  std::string text = format_smoothings(smoothed_by(of_lid)), row;
  const std::size_t at = text.find("\n      round");
  REQUIRE(at != std::string::npos);
  for (const char c : text.substr(at + 1)) {
    if (c == '\n') continue;
    if (c != ' ' || (!row.empty() && row.back() != ' ')) row += c;
  }
  return row;
}

}  // namespace

TEST_CASE("without smoothings, or shapes of any, there is no table", "[app][smoothing]") {
  CHECK(format_smoothings({}) == "");
  CHECK(format_smoothings(smoothed_by({})) == "");
}

TEST_CASE("shapes of the deck and those that were found have a row each", "[app][smoothing]") {
  SurfaceShapes shapes;
  RoundShape cylinder;
  cylinder.origin = {1, 2, 3};
  cylinder.axis = {0, 1e-12, 1};  // round-off is not reported
  shapes.given = {cylinder};
  CHECK(row_of_lid(shapes) == "round lid circumferential - of nodes - axis (0, 0, 1) through (1, 2, 3)");
  CHECK(format_smoothings(smoothed_by(shapes)).starts_with("\nRound shapes of surfaces\n      smoothing  "));

  shapes.given.clear();
  RoundShape ball;
  ball.kind = RoundShape::Kind::spherical;
  ball.origin = {0.5, 0, -1};
  shapes.fitted = {{ball, 2.5, 1e-4, 12}};
  CHECK(row_of_lid(shapes) == "round lid spherical 12 2.5 0.0001 about (0.5, 0, -1)");
  RoundShape torus;
  torus.kind = RoundShape::Kind::toroidal;
  torus.arc_radius = 10;
  shapes.fitted[0].shape = torus;
  CHECK(row_of_lid(shapes) ==
        "round lid toroidal 12 2.5 0.0001 axis (0, 0, 1) through (0, 0, 0), circle of 10");
}

TEST_CASE("parts that are not round, or flat, are reported", "[app][smoothing]") {
  SurfaceShapes shapes;
  shapes.n_unfitted = 2;
  shapes.least_residual = 0.0625;
  CHECK(row_of_lid(shapes) == "round lid none - - - 2 parts not round, by 0.0625 of the radius at least");
  shapes.n_unfitted = 1;
  shapes.least_residual = std::numeric_limits<double>::infinity();
  CHECK(row_of_lid(shapes) == "round lid none - - - 1 part not round");
  shapes = {};
  shapes.n_flat = 1;
  CHECK(row_of_lid(shapes) == "round lid flat - - - 1 flat part");
  shapes.fitted = {{RoundShape{}, 1.0, 0.0, 3}};  // then flat parts are nothing to tell
  CHECK(row_of_lid(shapes) == "round lid circumferential 3 1 0 axis (0, 0, 1) through (0, 0, 0)");
}
