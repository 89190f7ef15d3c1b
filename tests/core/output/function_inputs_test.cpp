// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/function_inputs.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a word of the deck is a variable, its component and its integration point", "[core][output]") {
  const VariableReference plain = split_reference({"Stress", {}});
  CHECK(plain.name.text == "Stress");
  CHECK(plain.component.empty());
  const VariableReference one = split_reference({"stress(XX,3)", {}});
  CHECK(one.name.text == "stress");
  CHECK(one.component == "xx");
  CHECK(one.integration_point == 3);
  const VariableReference all = split_reference({"stress(:,:)", {}});
  CHECK(all.component.empty());
  CHECK_FALSE(all.integration_point);
  CHECK(split_reference({"coordinates(x)", {}}).component == "x");
}
