// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/pair_node_values.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("values of nodes are found by pair and node, and go over to other nodes", "[contact]") {
  PairNodeValues<double> values;
  CHECK(values.empty());
  CHECK(values.value_or({0}, {3}, -1.0) == -1.0);
  values.set({{{1}, {2}, 0.5}, {{0}, {3}, 0.25}, {{1}, {0}, 0.125}});
  CHECK(values.value_or({0}, {3}, -1.0) == 0.25);
  CHECK(values.value_or({1}, {2}, -1.0) == 0.5);
  CHECK(values.value_or({0}, {2}, -1.0) == -1.0);
  ContactRemap remap;
  for (const int row : {5, -1, 0, -1})
    remap.rows.push_back(row < 0 ? OptionalIndex<SurfaceNodeIndex>()
                                 : SurfaceNodeIndex{static_cast<std::uint32_t>(row)});
  values.remap(remap);
  CHECK(values.value_or({1}, {0}, -1.0) == 0.5);
  CHECK(values.value_or({1}, {5}, -1.0) == 0.125);
  CHECK(values.value_or({0}, {3}, -1.0) == -1.0);
}
