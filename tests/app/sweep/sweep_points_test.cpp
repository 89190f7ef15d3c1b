// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/sweep_points.hpp"

#include <algorithm>
#include <set>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

SweepPlan plan_of(const std::vector<std::string>& definitions) {
  SweepPlan plan;
  for (const std::string& definition : definitions)
    plan.parameters.push_back(parse_sweep_parameter(definition));
  return plan;
}

std::string refusal(const SweepPlan& plan) {
  try {
    list_runs(plan);
  } catch (const DeckError& error) {
    return error.diagnostics().all().at(0).text;
  }
  return "";
}

}  // namespace

TEST_CASE("parameters are combined, the last changing fastest", "[app][sweep]") {
  const auto runs = list_runs(plan_of({"mu=0:0.2:0.1", "order=1,2"}));
  REQUIRE(runs.size() == 6);
  CHECK(runs[0].number == 1);
  CHECK(describe_point(runs[0].point) == "mu=0 order=1");
  CHECK(describe_point(runs[1].point) == "mu=0 order=2");
  CHECK(describe_point(runs[5].point) == "mu=0.2 order=2");
  CHECK(runs[5].folder == "mu=0.2_order=2");
  CHECK(list_runs({}).size() == 1);
}

TEST_CASE("a point's folder is short, plain and its own", "[app][sweep]") {
  CHECK(folder_of({{"mu", "-0.1"}}) == "mu=-0.1");
  CHECK(folder_of({}) == "run");
  const std::string odd = folder_of({{"way", "a/b c"}});
  CHECK(odd.starts_with("way=a_b_c_"));
  CHECK(odd != folder_of({{"way", "a_b/c"}}));
  CHECK(folder_of({{"x", std::string(500, 'y')}}).size() <= 100);
  CHECK(folder_of({{"x", "../../y"}}).find('/') == std::string::npos);
}

TEST_CASE("a Latin hypercube has one sample in each part of a range, by its seed", "[app][sweep]") {
  SweepPlan plan = plan_of({"speed=10:30", "mu=0.5:0:-0.1", "order=1,2"});
  plan.n_samples = 10;
  plan.seed = 7;
  const auto runs = list_runs(plan);
  REQUIRE(runs.size() == 10);
  std::set<int> parts;
  int n_of_one = 0;
  for (const SweepRun& run : runs) {
    const double speed = std::stod(run.point[0].second), mu = std::stod(run.point[1].second);
    CHECK((speed >= 10.0 && speed <= 30.0));
    CHECK((mu >= 0.0 && mu <= 0.5));
    parts.insert(std::min(9, static_cast<int>((speed - 10.0) / 2.0)));
    n_of_one += run.point[2].second == "1" ? 1 : 0;
  }
  CHECK(parts.size() == 10);
  CHECK(n_of_one == 5);
  CHECK(describe_point(list_runs(plan)[3].point) == describe_point(runs[3].point));
  plan.seed = 8;
  CHECK(describe_point(list_runs(plan)[3].point) != describe_point(runs[3].point));
}

TEST_CASE("points come from a file, each with all combinations of the rest", "[app][sweep]") {
  const test::TemporaryDirectory directory;
  SweepPlan plan = plan_of({"order=1,2"});
  plan.points_file = directory.file("points.csv");
  test::write_bytes(*plan.points_file, "mu, name\n0.1, \"a, b\"\n0.2, c d\n");
  const auto runs = list_runs(plan);
  REQUIRE(runs.size() == 4);
  CHECK(runs[1].point == SweepPoint{{"mu", "0.1"}, {"name", "a, b"}, {"order", "2"}});
  CHECK(runs[3].point == SweepPoint{{"mu", "0.2"}, {"name", "c d"}, {"order", "2"}});

  test::write_bytes(*plan.points_file, "mu,name\n0.1\n");
  CHECK_THROWS_WITH(list_runs(plan), Contains("line 2: 1 value for 2 names"));
  test::write_bytes(*plan.points_file, "mu,name\n");
  CHECK_THROWS_WITH(list_runs(plan), Contains("there are no points"));
  plan.points_file = directory.file("none.csv");
  CHECK_THROWS_WITH(list_runs(plan), Contains("none.csv"));
}

TEST_CASE("too many runs, names given twice and the same point twice are refused", "[app][sweep]") {
  SweepPlan plan = plan_of({"x=1:1000:1", "y=1:1000:1"});
  CHECK_THAT(refusal(plan), Contains("these are 1000000 runs, more than the 10000 that --max-runs allows"));
  plan = plan_of({"x=0:1e300:1e-300"});
  plan.max_runs = 1e6;
  CHECK_THAT(refusal(plan), Contains("--max-runs"));
  plan = plan_of({"x=1:20000:1"});
  plan.max_runs = 20000;
  CHECK(list_runs(plan).size() == 20000);
  CHECK_THAT(refusal(plan_of({"x=1", "x=2"})), Contains("'x' is given twice"));
  CHECK_THAT(refusal(plan_of({"x=1,1"})), Contains("runs 1 and 2 are the same: x=1"));
  CHECK_THAT(refusal(plan_of({"x=0:1"})), Contains("has no step"));
}
