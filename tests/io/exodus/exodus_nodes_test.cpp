// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_nodes.hpp"

#include <cmath>
#include <limits>

#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("coordinates that are missing, misshapen or not finite are refused", "[io][nodes]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) { file.rename_variable("coordx", "x"); }) ==
        "has nodes but no coordinates (variable coord)");
  CHECK(refusal(mesh, [](auto& file) { file.rename_variable("coordz", "z"); }) ==
        "has nodes but no coordinates (variable coordz)");
  CHECK(refusal(mesh, [](auto& file) {
          file.rename_variable("coordy", "y").add_dimension("few", 3).add_reals("coordy", {"few"}, {0, 1, 2});
        }) == "variable coordy does not match the number of nodes");
  CHECK(refusal(mesh, [](auto& file) { file.set_value("coordy", 6, std::nan("")); }) ==
        "node 7 (counted from 1): its y coordinate is nan");
  CHECK(refusal(mesh, [](auto& file) {
          file.set_value("coordz", 11, -std::numeric_limits<double>::infinity());
        }) == "node 12 (counted from 1): its z coordinate is -inf");
}

TEST_CASE("number maps that repeat an id are worth a warning", "[io][nodes]") {
  MeshBuilder builder = two_hexes();
  builder.set_element_ids({30, 30});
  CHECK(warnings_of(builder.build(), [](auto&) {}) ==
        "warning: element id 30 is given more than once (again at element number 2); it means the first "
        "[mesh-map-repeated]\n");
}

TEST_CASE("a number map of the wrong length is refused", "[io][nodes]") {
  CHECK(refusal(two_hexes().build(), [](auto& file) {
          file.add_integers("elem_num_map", {"num_dim"}, {1, 2, 3});
        }) == "variable elem_num_map does not match the 2 elements of the mesh");
}

TEST_CASE("number maps may pass 32 bits", "[io][nodes]") {
  MeshBuilder builder = two_hexes();
  const std::int64_t large = std::int64_t{1} << 40;
  builder.set_element_ids({large + 1, large});
  const Mesh found =
      reread(builder.build(), [](ExodusEditor&) {}, {.format = FileFormat::cdf5, .wide_integers = true});
  CHECK(found.element_id({0}) == large + 1);
  CHECK(found.find_element(large) == ElementIndex{1});
}
