// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/linear_advice.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

/// The element of first order with the same corners, as mesh generators call it; "" of linear shapes.
std::string_view linear_twin(Shape shape) {
  const Topology& facts = topology(shape);
  if (facts.n_nodes == facts.n_corners) return "";
  switch (facts.family) {
    case Family::solid:
      return facts.n_corners == 8   ? "HEX8"
             : facts.n_corners == 6 ? "WEDGE6"
             : facts.n_corners == 5 ? "PYRAMID5"
                                    : "TETRA4";
    case Family::shell:
      return facts.n_corners == 4 ? "SHELL4" : "SHELL3";
    case Family::line:
      return "BEAM2";
    default:
      return "";
  }
}

}  // namespace

std::string linear_advice(Shape shape, std::int64_t block_id) {
  const std::string_view twin = linear_twin(shape);
  if (twin.empty()) return "";
  const bool is_solid = topology(shape).family == Family::solid;
  return fmt::format(
      "their corners have no mass of their own, or a negative one; take {}{}: in Cubit BLOCK {} ELEMENT TYPE "
      "{} "
      "before EXPORT MESH, in Gmsh -order 1 (Mesh.ElementOrder = 1)",
      twin, is_solid ? " or TETRA10" : "", block_id, twin);
}

}  // namespace contactsim
