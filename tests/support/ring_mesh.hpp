// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// A ring of hexahedra around the axis z, one of them across and along it.
struct RingBlock {
  std::int64_t id = 1;
  std::string name = {};
  int n = 16;                   ///< elements around
  double from = 0.8, to = 1.0;  ///< radii [length]
  double turn = 0.0;            ///< of the first element [radians]
  double width = 0.2;           ///< along z, from 0 on [length]
};

inline void add_ring(MeshBuilder& b, const RingBlock& ring) {
  std::vector<std::uint32_t> nodes;
  const auto node = [&](int k, double r, double z) {
    const double angle = ring.turn + 2.0 * std::numbers::pi * k / ring.n;
    return b.add_node({r * std::cos(angle), r * std::sin(angle), z}).value;
  };
  std::vector<std::array<std::uint32_t, 4>> spokes;
  for (int k = 0; k < ring.n; ++k)
    spokes.push_back({node(k, ring.from, 0.0), node(k, ring.to, 0.0), node(k, ring.from, ring.width),
                      node(k, ring.to, ring.width)});
  for (int k = 0; k < ring.n; ++k) {
    const auto &a = spokes[static_cast<std::size_t>(k)],
               &c = spokes[static_cast<std::size_t>((k + 1) % ring.n)];
    for (const std::uint32_t i : {a[0], a[1], c[1], c[0], a[2], a[3], c[3], c[2]}) nodes.push_back(i);
  }
  b.add_block(ring.id, ring.name, Shape::hex8, nodes);
}

}  // namespace contactsim::test
