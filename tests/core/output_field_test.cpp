// SPDX-License-Identifier: BSD-3-Clause
#include "core/output_field.hpp"

#include <vector>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

std::vector<std::string> endings(int n_components) {
  std::vector<std::string> names;
  for (int c = 0; c < n_components; ++c) names.push_back(component_name("", c, n_components));
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("components are named so that readers join them", "[core][output]") {
  CHECK(component_name("mass", 0, 1) == "mass");
  CHECK(component_name("displ", 2, 3) == "displ_z");
  CHECK(endings(2) == Names{"_1", "_2"});
  CHECK(endings(3) == Names{"_x", "_y", "_z"});
  CHECK(endings(6) == Names{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx"});
  CHECK(endings(9) == Names{"_xx", "_yy", "_zz", "_xy", "_yz", "_zx", "_yx", "_zy", "_xz"});
}

TEST_CASE("numbered components are padded to one length", "[core][output]") {
  CHECK(component_name("q", 0, 9 + 1) == "q_01");
  CHECK(component_name("q", 9, 10) == "q_10");
  CHECK(component_name("q", 6, 8) == "q_7");
}
