// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_fields.hpp"

#include <cmath>

#include "support/catch.hpp"
#include "support/report_region.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Variables of these names over one time; each has its position as its value.
StoredVariables stored(std::vector<std::string> nodal, std::vector<std::string> element) {
  StoredVariables made;
  made.times = {0.0};
  const auto value = [](std::size_t variable, std::size_t) {
    return std::vector<double>(2, static_cast<double>(variable));
  };
  made.nodal = {std::move(nodal), value};
  made.element = {std::move(element), value};
  return made;
}

std::vector<std::string> names_of(const ReportFields& fields) {
  std::vector<std::string> names;
  for (const ReportField& field : fields.fields) names.push_back(field.name);
  return names;
}

}  // namespace

TEST_CASE("pressure and von Mises stress come first, components are joined", "[app][report]") {
  const StoredVariables of = stored({"displacement_x", "displacement_y", "displacement_z", "velocity_x",
                                     "velocity_y", "velocity_z", "status", "contact_pressure"},
                                    {"eqps", "von_mises", "death_status"});
  const ReportFields fields = choose_report_fields(of, {});
  CHECK(names_of(fields) ==
        std::vector<std::string>{"contact_pressure", "von_mises", "eqps", "|velocity|", "status"});
  CHECK(fields.not_found.empty());
  CHECK(fields.displacement(0).col(1) == Eigen::Vector3d(0, 1, 2));
  CHECK(fields.fields[3].read(0)[0] == Approx(std::sqrt(9.0 + 16.0 + 25.0)));
}

TEST_CASE("names of the deck are known by what they stand for", "[app][report]") {
  const SimulationDefinition deck = deck_of_region(
      "begin results output\ndatabase name = r.e\nnodal displacement as u\n"
      "nodal contact_normal_traction_magnitude as p\nelement von_mises as mises\nend");
  const StoredNames names(region_of(deck));
  CHECK(names.variable_of("P") == "contact_normal_traction_magnitude");
  CHECK(names.variable_of("other") == "other");
  const StoredVariables of = stored({"u_x", "u_y", "u_z", "a", "p"}, {"mises"});
  const ReportFields fields = choose_report_fields(of, names);
  CHECK(names_of(fields) == std::vector<std::string>{"p", "mises", "a"});
  CHECK(fields.not_found.empty());
  REQUIRE(fields.displacement);
}

TEST_CASE("von Mises stress is made of a stored stress", "[app][report]") {
  const StoredVariables of =
      stored({}, {"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx"});
  const ReportFields fields = choose_report_fields(of, {});
  REQUIRE(names_of(fields) == std::vector<std::string>{"von_mises"});
  // xx yy zz = 0 1 2: sqrt((1 + 1 + 4) / 2 + 3 (9 + 16 + 25))
  CHECK(fields.fields[0].read(0)[1] == Approx(std::sqrt(3.0 + 150.0)));
}

TEST_CASE("what is not stored is reported with the line that would store it, what is too much by name",
          "[app][report]") {
  const StoredVariables of = stored({"a", "b", "c", "d", "e", "f", "g", "h", "i"}, {});
  const ReportFields fields = choose_report_fields(of, {});
  CHECK(fields.left_out == std::vector<std::string>{"i"});
  REQUIRE(fields.not_found.size() == 3);
  CHECK_THAT(fields.not_found[0], Contains("output nodal displacement"));
  CHECK_THAT(fields.not_found[1], Contains("output nodal contact_normal_traction_magnitude"));
  CHECK_THAT(fields.not_found[2], Contains("output element von_mises"));
  CHECK_FALSE(fields.displacement);
  StoredVariables none = stored({}, {});
  none.times.clear();
  CHECK_THAT(choose_report_fields(none, {}).not_found.front(), Contains("No results over time"));
}
