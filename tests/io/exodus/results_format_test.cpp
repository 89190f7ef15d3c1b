// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/results_format.hpp"

#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("the largest variable, id and name decide the format", "[io][results]") {
  MeshParts parts = two_hexes().parts();
  const std::vector<OutputField> fields{{"velocity", FieldLocation::node, FieldShape::vector, 3}};
  ResultsSizes sizes = find_results_sizes(Mesh(parts), fields);
  CHECK(sizes.n_variable_bytes == 12 * sizeof(double));
  CHECK(sizes.largest_id == 100);
  CHECK(sizes.longest_name == std::string("velocity_x").size());

  parts.blocks[0].attribute_names = {"a name of twenty-two!!", "b", "c"};
  parts.blocks[0].attributes.assign(3, 0.0);
  parts.side_sets[0].distribution_factors.assign(40, 1.0);
  parts.node_ids = {5, 4, 3, 2, 1, 6, 7, 8, 9, 10, 11, 1200};
  sizes = find_results_sizes(Mesh(parts), fields);
  CHECK(sizes.n_variable_bytes == 40 * sizeof(double));
  CHECK(sizes.largest_id == 1200);
  CHECK(sizes.longest_name == 22);
}

TEST_CASE("a file is as large as it must be", "[io][results]") {
  constexpr std::int64_t largest_int32 = 2147483647;
  constexpr std::size_t limit = 4294967292;  // 2^32 - 4
  CHECK_FALSE(choose_format({limit, largest_int32, 0}).is_large);
  CHECK_FALSE(choose_format({limit, largest_int32, 0}).has_wide_ids);
  CHECK(choose_format({limit + 1, 0, 0}).is_large);
  CHECK_FALSE(choose_format({limit + 1, 0, 0}).has_wide_ids);
  CHECK(choose_format({0, largest_int32 + 1, 0}).is_large);
  CHECK(choose_format({0, largest_int32 + 1, 0}).has_wide_ids);
  CHECK(choose_format({0, 0, 5}).name_length == 32);
  CHECK(choose_format({0, 0, 33}).name_length == 33);
}
