// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/variable_readers.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// What the reading of one line of an element death says.
std::string line_messages(const std::string& line) {
  return bound_region("begin element death\n" + line + "\nend\n").messages;
}

VariableReference reference_of(const std::string& text) {
  const BoundRegion bound =
      bound_region("begin element death\ncriterion is element value of " + text + " > 1\nend\n");
  CHECK(bound.messages == "");
  return std::get<ElementCriterion>(bound.region.element_deaths.at(0).criteria.at(0)).test.variable;
}

}  // namespace

TEST_CASE("a variable may name a component and an integration point", "[parser][variable]") {
  CHECK(reference_of("stress").name.text == "stress");
  CHECK(reference_of("stress").component == "");
  CHECK_FALSE(reference_of("stress").integration_point);
  CHECK(reference_of("Stress(XX)").name.text == "Stress");
  CHECK(reference_of("stress(XX)").component == "xx");
  CHECK(reference_of("stress(xy, 3)").component == "xy");
  CHECK(reference_of("stress(xy, 3)").integration_point == 3);
  CHECK(reference_of("stress(2,1)").component == "2");
}

TEST_CASE("a colon or a star stands for all components or points", "[parser][variable]") {
  CHECK(reference_of("stress(:,:)").component == "");
  CHECK_FALSE(reference_of("stress(:,:)").integration_point);
  CHECK(reference_of("stress(*,2)").component == "");
  CHECK(reference_of("stress(*,2)").integration_point == 2);
  CHECK_FALSE(reference_of("stress(zz,*)").integration_point);
}

TEST_CASE("a wrong variable is reported", "[parser][variable]") {
  CHECK(line_messages("criterion is element value of stress(xx,0) > 1") ==
        "a.i:2:31: error: expected an integration point from 1, found '0'\n");
  CHECK(line_messages("criterion is element value of stress(,1) > 1") ==
        "a.i:2:31: error: expected a component in 'stress(,1)'\n");
  CHECK(line_messages("criterion is element value of > 1") ==
        "a.i:2:31: error: expected a variable after 'criterion', found '>'\n");
  CHECK(line_messages("criterion is element value of 3 > 1") ==
        "a.i:2:31: error: expected a variable after 'criterion', found '3'\n");
  CHECK(line_messages("criterion is element value of") ==
        "a.i:2:1: error: expected a variable after 'criterion', found the end of the line\n");
}

TEST_CASE("every comparison is read", "[parser][variable]") {
  const auto [op, comparison] = GENERATE(table<std::string, Comparison>({
      {"<", Comparison::less},
      {"<=", Comparison::less_equal},
      {"=", Comparison::equal},
      {"==", Comparison::equal},
      {">=", Comparison::greater_equal},
      {">", Comparison::greater},
  }));
  const BoundRegion bound =
      bound_region("begin element death\ncriterion is element value of eqps" + op + "0.5\nend\n");
  CHECK(bound.messages == "");
  const auto criterion = std::get<ElementCriterion>(bound.region.element_deaths.at(0).criteria.at(0));
  CHECK(criterion.test.comparison == comparison);
  CHECK(criterion.test.value == 0.5);
}

TEST_CASE("a test without comparison or value is reported", "[parser][variable]") {
  CHECK(line_messages("criterion is element value of eqps 0.5") ==
        "a.i:2:36: error: expected one of <, <=, =, >=, > after 'eqps', found '0.5'\n");
  CHECK(line_messages("criterion is element value of eqps >") ==
        "a.i:2:1: error: expected a number after 'criterion', found the end of the line\n");
}
