// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/curves.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("energies share a chart, components another, the rest have their own", "[app][report]") {
  const ColumnTable table = read_heartbeat_columns("runs/a.csv",
                                                   "Time, kinetic_energy, force_x, force_y, gap, Internal\n"
                                                   "[time], [energy], [force], [force], [length], [energy]\n"
                                                   "0, 1, 2, 3, 4, 5\n"
                                                   "1, 6, 7, 8, nan, 10\n");
  CHECK(table.times == std::vector<double>{0.0, 1.0});
  const std::vector<CurveChart> charts = make_charts(table);
  REQUIRE(charts.size() == 3);
  CHECK(charts[0].title == "Energies");
  CHECK(charts[0].source == "a.csv");
  REQUIRE(charts[0].curves.size() == 2);
  CHECK(charts[0].curves[1].name == "Internal");
  CHECK(charts[0].curves[1].values == std::vector<double>{5.0, 10.0});
  CHECK(charts[1].title == "force");
  CHECK(charts[1].dimension == "force");
  CHECK(charts[1].curves.size() == 2);
  CHECK(charts[2].title == "gap");
  CHECK(charts[2].dimension == "length");
}

TEST_CASE("of many times a thousand are kept, the last one too", "[app][report]") {
  ColumnTable table{"a.e", {"n"}, {}, {}, {{}}};
  for (int i = 0; i < 12'345; ++i) {
    table.times.push_back(i);
    table.columns[0].push_back(2.0 * i);
  }
  const CurveChart chart = make_charts(table).front();
  CHECK(chart.times.size() == 1000);
  CHECK(chart.times.front() == 0.0);
  CHECK(chart.times.back() == 12'344.0);
  CHECK(chart.curves[0].values.back() == 2.0 * 12'344.0);
}

TEST_CASE("no lines are no charts, a broken one is named", "[app][report]") {
  CHECK(make_charts(read_heartbeat_columns("a.csv", "Time, n\n")).empty());
  CHECK_THROWS_AS(read_heartbeat_columns("a.csv", "Time, n\n0, x\n"), FileError);
}
