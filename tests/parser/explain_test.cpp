// SPDX-License-Identifier: BSD-3-Clause
#include "parser/explain.hpp"

#include <iostream>
#include <vector>
#include "support/catch.hpp"

using namespace contactsim;
TEST_CASE("look", "[explain]") {
  std::vector<std::string> none, a{"Begin", "time", "control"}, b{"scale"}, c{"frictoin"};
  std::cout << explain(none) << "-----\n" << explain(a) << "-----\n" << explain(b) << "-----\n" << explain(c);
}
