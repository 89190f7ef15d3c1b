// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/node_groups.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("what eight nodes have stands once for each component of each", "[core][dynamics]") {
  const double of_nodes[nodes_per_group] = {1.5, -2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.25};
  const NodeGroup group = repeat_thrice(of_nodes);
  for (Eigen::Index i = 0; i < group_size; ++i) CHECK(group(i) == of_nodes[i / 3]);
}
