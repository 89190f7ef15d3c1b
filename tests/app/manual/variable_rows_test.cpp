// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/variable_rows.hpp"

#include <algorithm>
#include <set>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

const VariableText& variable_called(const std::vector<VariableText>& rows, const std::string& name) {
  const auto found = std::ranges::find(rows, name, &VariableText::name);
  REQUIRE(found != rows.end());
  return *found;
}

}  // namespace

TEST_CASE("every output variable has its place, its components and its help", "[app][manual]") {
  const std::vector<VariableText> rows = output_variables();
  CHECK(variable_called(rows, "kinetic_energy").location == "global");
  CHECK(variable_called(rows, "displacement").location == "nodal");
  CHECK(variable_called(rows, "displacement").n_components == 3);
  CHECK(variable_called(rows, "stress").n_components == 6);
  CHECK(variable_called(rows, "von_mises").location == "element");
  CHECK(variable_called(rows, "eqps").location == "element");  // that a material keeps
  for (const VariableText& row : rows) {
    INFO(row.name);
    CHECK_FALSE(row.help.empty());
    CHECK((row.location == "global" || row.location == "nodal" || row.location == "element"));
    if (row.n_components == 0) CHECK(row.help.find(": all of ") != std::string::npos);
  }
}

TEST_CASE("totals of contact stand for surfaces and for pairs", "[app][manual]") {
  const std::vector<VariableText> rows = output_variables();
  CHECK(variable_called(rows, "contact_force_<surface or side set>").n_components == 3);
  CHECK(variable_called(rows, "contact_force_<first>_<second>").n_components == 3);
}

TEST_CASE("no two lines of output variables are the same", "[app][manual]") {
  std::set<std::tuple<std::string, std::string, std::string>> known;
  for (const VariableText& row : output_variables()) {
    INFO(row.name);
    CHECK(known.emplace(row.location, row.name, row.help).second);
  }
}
