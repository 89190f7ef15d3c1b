// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/side_factors.hpp"

#include "io/netcdf/read_layout.hpp"
#include "io/pieces/split_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Counts = std::vector<std::size_t>;

TEST_CASE("a side has the nodes of its shape, mid nodes included", "[io][pieces]") {
  CHECK(count_side_nodes(Shape::hex8, 1) == 4);
  CHECK(count_side_nodes(Shape::hex27, 1) == 9);
  CHECK(count_side_nodes(Shape::wedge6, 4) == 3);
  CHECK(count_side_nodes(Shape::tet10, 1) == 6);
  CHECK(count_side_nodes(Shape::shell4, 3) == 2);
  CHECK_FALSE(count_side_nodes(Shape::unknown, 1));
}

TEST_CASE("factors are divided by the nodes of sides, else evenly", "[io][pieces]") {
  const std::vector<ShapedSide> sides{{Shape::wedge6, 1}, {Shape::wedge6, 4}, {Shape::shell4, 3}};
  CHECK(divide_factors(sides, 9) == Counts{4, 3, 2});
  CHECK(divide_factors(sides, 3) == Counts{1, 1, 1});
  CHECK(divide_factors(sides, 6) == Counts{2, 2, 2});
  CHECK_FALSE(divide_factors(sides, 10));
  CHECK_FALSE(divide_factors({}, 1));
  const std::vector<ShapedSide> wild{{Shape::hex8, 7}, {Shape::hex8, 0}};
  CHECK(divide_factors(wild, 8) == Counts{4, 4});
}

TEST_CASE("elements have the shapes of their blocks", "[io][pieces]") {
  const TemporaryDirectory directory;
  write_exodus(directory.file("m.g"), sample_mesh().build());
  const NetcdfFile file(directory.file("m.g"));
  const ElementShapes shapes(file, read_layout(file));
  const Mesh mesh = sample_mesh().build();
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e)
    CHECK(shapes.of(e) == mesh.blocks()[mesh.block_of({e})].shape);
  CHECK(shapes.of(mesh.n_elements()) == Shape::unknown);
}
