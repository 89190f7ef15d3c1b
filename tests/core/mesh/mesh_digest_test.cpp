// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/mesh_digest.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using test::MeshBuilder;

TEST_CASE("a mesh has the digest of what a run sees of it", "[core][mesh]") {
  const MeshParts parts = MeshBuilder().add_hexes({.id = 1, .cells = {2, 1, 1}}).parts();
  const std::uint64_t digest = digest_of(Mesh(parts));
  const auto changed = [&](const auto& change) {
    MeshParts other = parts;
    change(other);
    return digest_of(Mesh(other)) != digest;
  };
  CHECK_FALSE(changed([](MeshParts&) {}));
  CHECK_FALSE(
      changed([](MeshParts& p) { p.path = "elsewhere.g", p.title = "another", p.blocks[0].name = "lid"; }));
  CHECK(changed([](MeshParts& p) { p.coordinates(2, 11) = std::nextafter(p.coordinates(2, 11), 9.0); }));
  CHECK(changed([](MeshParts& p) { p.coordinates.col(0).swap(p.coordinates.col(1)); }));
  CHECK(changed([](MeshParts& p) { std::swap(p.blocks[0].nodes[0], p.blocks[0].nodes[1]); }));
  CHECK(changed([](MeshParts& p) { p.blocks[0].id = 2; }));
  CHECK(changed([](MeshParts& p) { p.blocks[0].shape = Shape::cohesive8; }));
  CHECK(changed([](MeshParts& p) {
    p.coordinates.conservativeResize(3, p.coordinates.cols() + 1), p.coordinates.rightCols(1).setZero();
  }));
}
