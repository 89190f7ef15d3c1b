// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/linear_advice.hpp"

#include "core/mesh/topology.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("for elements of second order there is advice by the words of mesh generators",
          "[core][elements]") {
  CHECK(linear_advice(Shape::hex20, 7) ==
        "their corners have no mass of their own, or a negative one; take HEX8 or TETRA10: in Cubit BLOCK 7 "
        "ELEMENT "
        "TYPE HEX8 before EXPORT MESH, in Gmsh -order 1 (Mesh.ElementOrder = 1)");
  const auto takes = [](Shape shape, const std::string& twin) {
    return linear_advice(shape, 2).find("take " + twin + ": in Cubit BLOCK 2 ELEMENT TYPE") !=
           std::string::npos;
  };
  CHECK(takes(Shape::hex27, "HEX8 or TETRA10"));
  CHECK(takes(Shape::wedge15, "WEDGE6 or TETRA10"));
  CHECK(takes(Shape::pyramid13, "PYRAMID5 or TETRA10"));
  CHECK(takes(Shape::shell6, "SHELL3"));
  CHECK(takes(Shape::shell8, "SHELL4"));
}

TEST_CASE("elements of first order need no advice", "[core][elements]") {
  for (const Shape shape :
       {Shape::hex8, Shape::tet4, Shape::wedge6, Shape::pyramid5, Shape::shell4, Shape::shell3, Shape::beam2,
        Shape::bar2, Shape::sphere, Shape::cohesive8, Shape::unknown})
    CHECK(linear_advice(shape, 1).empty());
}
