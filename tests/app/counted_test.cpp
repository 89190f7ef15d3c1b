// SPDX-License-Identifier: BSD-3-Clause
#include "app/counted.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("things are counted in the singular and the plural", "[app][counted]") {
  CHECK(counted(0, "node") == "0 nodes");
  CHECK(counted(1, "node") == "1 node");
  CHECK(counted(2, "node") == "2 nodes");
  CHECK(counted(1, "assembly", "assemblies") == "1 assembly");
  CHECK(counted(3, "assembly", "assemblies") == "3 assemblies");
}
