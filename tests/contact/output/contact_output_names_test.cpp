// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "contact/output/contact_output.hpp"
#include "core/base/names.hpp"
#include "core/output/output_variables.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"
#include "support/watched_contact.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("groups stand for variables that there are, and other names for ours",
          "[contact][contact_output]") {
  std::set<std::string> known, names;
  for (const ContactNodeRow& row : contact_node_rows()) known.insert(std::string(row.name));
  for (const OutputGroup& group : contact_output_names().groups) {
    CHECK(names.insert(std::string(group.name)).second);
    CHECK(group.help.back() == ']');
    for (const std::string_view member : group.members) CHECK(known.contains(std::string(member)));
    known.insert("the group " + std::string(group.name));
  }
  for (const ContactTotalRow& row : contact_total_rows()) known.insert(std::string(row.name) + "_<surface>");
  for (const ForeignVariable& foreign : contact_output_names().foreign) {
    INFO(foreign.name);
    CHECK(names.insert(std::string(foreign.name)).second);
    const std::string ours = fold(foreign.ours),
                      first = std::string(foreign.ours.substr(0, foreign.ours.find_first_of(",(")));
    CHECK((known.contains(first) || ours == "the_group_cstress"));
  }
}

TEST_CASE("a group of contact asked for in a deck is written as its members", "[contact][contact_output]") {
  WatchedContact bodies(cube_over_cube(0.0), general_contact());
  const OutputVariables known(bodies.model, bodies.variables, contact_output_names());
  const auto expanded = [&](const std::string& group) {
    VariableRequest asked;
    asked.variable.name.text = group;
    asked.location = VariableLocation::nodal;
    Diagnostics diagnostics;
    std::vector<std::string> written;
    for (const VariableRequest& one : expand_groups(known, std::span(&asked, 1), diagnostics)) {
      written.push_back(output_name(one));
      CHECK(known.find(FieldLocation::node, output_name(one)) != nullptr);
    }
    CHECK(diagnostics.all().empty());
    return written;
  };
  using Names = std::vector<std::string>;
  CHECK(expanded("cstress") ==
        Names{"contact_normal_traction_magnitude", "contact_tangential_traction_magnitude"});
  CHECK(expanded("CFORCE") == Names{"contact_normal_force", "contact_tangential_force"});
  CHECK(expanded("ctandir") == Names{"contact_tangential_direction"});
}
