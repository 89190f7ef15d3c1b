// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/interface_law_table.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

#include "core/interface_laws/pressure_velocity.hpp"
#include "support/catch.hpp"
#include "support/friction_law.hpp"
#include "support/function_definition.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A plausible value for a parameter.
ParameterValue example_of(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::function:
      return DeckName{"f", {}};
    case ParameterKind::models_by_period:
      return std::vector<PeriodModel>{{{"tied", {}}, {{"p", {}}}}};
    default:
      return 0.5;
  }
}

/// A law of a row with all that is required.
FrictionLaw whole_law(const InterfaceLawRow& row) {
  FrictionLaw law = make_friction_law(row.name);
  for (const Parameter& parameter : row.parameters) {
    if (parameter.is_required) law.values.set(parameter.phrase, example_of(parameter));
  }
  return law;
}

std::optional<InterfaceLaw> make(const FrictionLaw& law) {
  const FunctionDefinition function =
      table_function(FunctionType::piecewise_linear, {{0.0, 0.0}, {0.5, 10.0}, {1.0, 15.0}});
  Diagnostics diagnostics;
  auto made = row_of(law).make({law.values, {&function, 1}, diagnostics});
  CHECK(diagnostics.empty());
  return made;
}

}  // namespace

TEST_CASE("every interface law has a name of its own and parameters with help",
          "[core][interface_laws][conformance]") {
  std::set<std::string> names;
  for (const InterfaceLawRow& row : interface_law_rows()) {
    INFO(row.name);
    CHECK(names.insert(row.name).second);
    CHECK_FALSE(row.help.empty());
    CHECK(&row_of(make_friction_law(row.name)) == &row);
    CHECK_FALSE(describe_law(make_friction_law(row.name)).empty());
    std::set<std::string> phrases;
    for (const Parameter& parameter : row.parameters) {
      CHECK_FALSE(parameter.help.empty());
      CHECK(phrases.insert(parameter.phrase).second);
    }
  }
  CHECK_THROWS_AS(make_friction_law("velcro"), std::logic_error);
}

TEST_CASE("every interface law is made of what it requires, and says what is missing",
          "[core][interface_laws][conformance]") {
  for (const InterfaceLawRow& row : interface_law_rows()) {
    INFO(row.name);
    const FrictionLaw law = whole_law(row);
    CHECK(missing_parameters(row.parameters, law.values).empty());
    for (const Parameter& parameter : row.parameters) {
      if (!parameter.is_required) continue;
      FrictionLaw lacking = law;
      lacking.values.set(parameter.phrase, {});
      CHECK(missing_parameters(row.parameters, lacking.values) == std::vector{parameter.phrase});
    }
    CHECK((row.make == nullptr || row.select == nullptr));
    if (row.make != nullptr) CHECK(make(law));
    if (row.select != nullptr) CHECK_NOTHROW(row.select(law.values));
  }
}

TEST_CASE("every interface law does what its row says", "[core][interface_laws][conformance]") {
  for (const InterfaceLawRow& row : interface_law_rows()) {
    INFO(row.name);
    if (row.make == nullptr) continue;
    const auto law = make(whole_law(row));
    REQUIRE(law);
    CHECK(row.holding == ContactLaw::sliding);  // what holds for good needs no more than that
    CHECK(law->holds() == row.holds_at_start);
    CHECK(row.slides() == !row.holds_at_start);
    CHECK_FALSE((law->bond_law && law->weld));
    CHECK(law->pressure.has_value() == row.has_pressure);
    CHECK((law->law == ContactLaw::welded) == law->weld.has_value());
    CHECK(std::isfinite(law->slip_limit(1.0, 1.0, 1.0)));
    CHECK((!law->limit || law->friction > 0.0));  // 0 would leave friction out
    if (!law->bond_law) continue;
    BondHistory history;
    const BondForce force = law->bond_law->force({0.01, 0.02, 1.0, 1e3}, history);
    CHECK(force.normal > 0.0);
    CHECK(force.tangential > 0.0);
    CHECK(force.stored > 0.0);
    CHECK(law->bond_law->stiffness(1e3) > 0.0);
    BondHistory closed;
    CHECK(law->bond_law->force({0.0, 0.0, 1.0, 1e3}, closed).normal == 0.0);
  }
}

TEST_CASE("laws are described in words", "[core][interface_laws]") {
  CHECK(describe_law({}) == "frictionless");
  CHECK(describe_law(coulomb(0.3)) == "friction 0.3");
  for (const char* name : {"tied", "glued", "surface weld", "area weld", "cohesive zone", "pv dependent"})
    CHECK(describe_law(friction_law(name)) == name);
}

TEST_CASE("static and dynamic coefficients need no reference pressure", "[core][interface_laws]") {
  const auto law = make(friction_law(
      "pv dependent", {{"static coefficient", 0.5}, {"dynamic coefficient", 0.2}, {"velocity decay", 3.0}}));
  REQUIRE(law);
  // Coulomb's law by the slip rate, whatever the area.
  for (const double area : {0.01, 1.0, 7.0}) {
    CHECK(law->slip_limit(10.0, area, 0.0) == Approx(5.0));
    CHECK(law->slip_limit(10.0, area, 1e3) == Approx(2.0));
    CHECK(law->slip_limit(10.0, area, 0.5) == Approx(10.0 * (0.2 + 0.3 * std::exp(-1.5))));
  }
}

TEST_CASE("what may follow a failed weld slides", "[core][interface_laws]") {
  std::set<std::string> sliding;
  for (const InterfaceLawRow& row : interface_law_rows()) {
    if (row.slides()) sliding.insert(row.name);
  }
  CHECK(sliding == std::set<std::string>{"frictionless", "constant friction", "stick", "adhesion", "junction",
                                         "pv dependent", "pressure function", "exponential pressure"});
}

TEST_CASE("friction by pressure and speed falls from the static to the dynamic coefficient",
          "[core][interface_laws]") {
  const PressureVelocityFriction pv{0.6, 0.2, 2.0, 10.0, 0.0, 1.0};
  CHECK(pv(20.0, 1.0, 0.0) == Approx(0.6 * 2.0));
  CHECK(pv(20.0, 1.0, 1e3) == Approx(0.2 * 2.0));
  CHECK(pv(20.0, 1.0, 0.5) == Approx((0.2 + 0.4 * std::exp(-1.0)) * 2.0));
  CHECK(pv(20.0, 4.0, 0.0) == Approx(0.6 * 0.5 * 4.0));  // the pressure is 5
}
