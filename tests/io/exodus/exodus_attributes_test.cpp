// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_attributes.hpp"

#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Names = std::vector<std::string>;

Names names_of(const std::string& type, int n_nodes, std::size_t n_attributes) {
  ElementBlock block;
  block.type_name = type;
  block.nodes_per_element = n_nodes;
  block.shape = find_shape(type, n_nodes);
  return default_attribute_names(block, n_attributes);
}

}  // namespace

TEST_CASE("attributes without names are named by the element type", "[io][attributes]") {
  CHECK(names_of("SPHERE", 1, 1) == Names{"radius"});
  CHECK(names_of("CIRCLE", 1, 3) == Names{"radius", "volume", "attribute_3"});
  CHECK(names_of("sphere-mass", 1, 10)[1] == "inertia_xx");
  CHECK(names_of("SHELL4", 4, 1) == Names{"thickness"});
  CHECK(names_of("quad", 4, 1) == Names{"thickness"});
  CHECK(names_of("TRI", 3, 3) == Names{"nodal_thickness_1", "nodal_thickness_2", "nodal_thickness_3"});
  CHECK(names_of("TRUSS", 2, 1) == Names{"area"});
  CHECK(names_of("BEAM", 2, 7) ==
        Names{"area", "i1", "i2", "j", "reference_axis_x", "reference_axis_y", "reference_axis_z"});
  CHECK(names_of("HEX", 8, 2) == Names{"attribute_1", "attribute_2"});
  CHECK(names_of("FROBNICATE", 8, 1) == Names{"attribute_1"});
}

TEST_CASE("stored attribute names win, blank ones do not", "[io][attributes]") {
  MeshBuilder builder;
  builder.add_spheres(1, "", {{0, 0, 0}}).set_attributes(1, {"size", ""}, {3.0, 4.0});
  const Mesh found = reread(builder.build(), [](auto&) {});
  CHECK(found.blocks()[0].attribute_names == Names{"size", "volume"});
  CHECK(found.blocks()[0].attributes == std::vector<double>{3.0, 4.0});
}

TEST_CASE("attributes that do not match their block are refused", "[io][attributes]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) {
          file.add_reals("attrib1", {"num_dim", "num_el_blk"}, std::vector<double>(6));
        }) == "block 10 (lower): its attributes (variable attrib1) do not match its 1 elements");
  MeshBuilder builder;
  builder.add_spheres(1, "", {{0, 0, 0}}).set_attributes(1, {"size", "weight"}, {3.0, 4.0});
  CHECK(
      refusal(builder.build(), [](auto& file) {
        file.rename_variable("attrib1", "old").add_reals("attrib1", {"num_el_in_blk1", "num_el_blk"}, {1.0});
      }) == "block 1: has 1 attributes but 2 names for them");
}
