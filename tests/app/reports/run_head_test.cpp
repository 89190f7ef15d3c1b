// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/run_head.hpp"

#include <regex>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("the head of a log has moment, command and machine, variables where there are any",
          "[app][report]") {
  const std::vector<std::string> variables{"mu=0.1", "name=a b"};
  const std::regex whole(
      "  date       \\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d UTC\n  command    contactsim a\\.i\n"
      "  host       [^\n]+, 3 of \\d+ processors, [^\n]+\n");
  CHECK(std::regex_match(format_run_head("contactsim a.i", {}, 1, 3), whole));
  const std::string text = format_run_head("contactsim a.i", variables, 1, 3);
  CHECK_THAT(text, Catch::Contains("\n  command    contactsim a.i\n  variables  mu=0.1 name=a b\n  host "));
}

TEST_CASE("an estimate has steps and element-steps, and of files their bytes", "[app][check]") {
  RunEstimate estimate;
  estimate.stable_step = 2e-6;
  estimate.step = 1.8e-6;
  estimate.n_steps = 1000;
  estimate.n_elements = 25;
  estimate.seconds_per_step = 1e-3;
  const std::string head =
      "\nA run of this deck\n  stable time step  2e-06, steps of 1.8e-06 at the start\n"
      "  steps             1000, of 25 elements: 2.5e+04 element-steps\n";
  CHECK(format_estimate(estimate) == head);
  estimate.files = {{"a.e", 11, 5000}};
  CHECK(format_estimate(estimate) ==
        head +
            "  file                                         steps           bytes\n"
            "  a.e                                             11            5000\n");
  estimate.files.push_back({"a.csv", 3, 70});
  const std::string two = format_estimate(estimate);
  CHECK(
      two.ends_with("  a.csv                                            3              70\n"
                    "  in all                                                        5070\n"));
}

TEST_CASE("an estimate of load steps has no stable step", "[app][check]") {
  RunEstimate estimate;
  estimate.step = 0.1;
  estimate.n_steps = 10;
  estimate.n_elements = 1;
  CHECK(format_estimate(estimate) ==
        "\nA run of this deck\n  load steps of 0.1 at the start\n"
        "  steps             10, of 1 elements: 10 element-steps\n");
}

TEST_CASE("the time of an estimate is that of all steps", "[app][check]") {
  RunEstimate estimate;
  estimate.n_steps = 1000;
  estimate.seconds_per_step = 2.5e-3;
  const std::regex one(
      "  about 2\\.5 s of the clock on 1 thread besides writing files; [1-9]\\d* MiB of memory\n");
  CHECK(std::regex_match(format_estimated_time(estimate, 1), one));
  CHECK_THAT(format_estimated_time(estimate, 4), Catch::Contains(" on 4 threads besides "));
}
