// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/sweep_parameter.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

std::vector<std::string> values(const std::string& text) {
  const SweepParameter parameter = parse_sweep_parameter(text);
  std::vector<std::string> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(parameter.n_values()); ++i)
    all.push_back(parameter.value(i));
  return all;
}

using Values = std::vector<std::string>;

/// The message with which a parameter is refused.
std::string refusal(const std::string& text) {
  try {
    parse_sweep_parameter(text);
  } catch (const DeckError& error) {
    return error.diagnostics().all().at(0).text;
  }
  return "";
}

}  // namespace

TEST_CASE("a range has its last value, whatever round-off does", "[app][sweep]") {
  CHECK(values("mu=0:0.5:0.1") == Values{"0", "0.1", "0.2", "0.3", "0.4", "0.5"});
  CHECK(values("x=0:1:0.3") == Values{"0", "0.3", "0.6", "0.9"});
  CHECK(values("x=-0.3:0.3:0.1") == Values{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"});
  CHECK(values("x=1:-1:-1") == Values{"1", "0", "-1"});
  CHECK(values("x=2:2:1") == Values{"2"});
  CHECK(values("x=1e-6:3e-6:1e-6") == Values{"1e-06", "2e-06", "3e-06"});
  CHECK(parse_sweep_parameter("x=0:1e6:1").n_values() == 1000001.0);
}

TEST_CASE("lists and single values are taken as they are", "[app][sweep]") {
  CHECK(values("order=1,2") == Values{"1", "2"});
  CHECK(values("way=flat, on edge") == Values{"flat", "on edge"});
  CHECK(values("name=\"a,b\",c") == Values{"a,b", "c"});
  CHECK(values("x=") == Values{""});
  CHECK(values("x=a=b") == Values{"a=b"});
  CHECK(values("file=C:data") == Values{"C:data"});
  CHECK(values("word=\"flat\"") == Values{"\"flat\""});
}

TEST_CASE("what is no range, list or value is refused", "[app][sweep]") {
  CHECK_THAT(refusal("mu"), Contains("expected name=value"));
  CHECK_THAT(refusal("=1"), Contains("expected name=value"));
  CHECK_THAT(refusal("mu=0:1:0"), Contains("-D mu=0:1:0: the step is zero"));
  CHECK_THAT(refusal("mu=0:1:-0.1"), Contains("the step leads away"));
  CHECK_THAT(refusal("mu=1:0:0.1"), Contains("the step leads away"));
  CHECK_THAT(refusal("mu=0:a:1"), Contains("three numbers"));
  CHECK_THAT(refusal("mu=0:1:1:1"), Contains("three numbers"));
  CHECK_THAT(refusal("mu=0:inf:1"), Contains("finite"));
  CHECK_THAT(refusal("mu=1,,2"), Contains("empty value"));
}
