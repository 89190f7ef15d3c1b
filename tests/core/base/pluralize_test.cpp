// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/pluralize.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("things are counted in the singular and the plural", "[core][base]") {
  CHECK(pluralize(0, "node") == "0 nodes");
  CHECK(pluralize(1, "node") == "1 node");
  CHECK(pluralize(2, "node") == "2 nodes");
  CHECK(pluralize(1, "assembly", "assemblies") == "1 assembly");
  CHECK(pluralize(3, "assembly", "assemblies") == "3 assemblies");
}
