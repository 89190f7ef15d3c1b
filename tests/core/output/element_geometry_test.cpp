// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/element_geometry.hpp"

#include "core/mesh/mesh.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

double volume_of(const Topology& topology, const ElementVectors& x) {
  return solid_volume(x, volume_gradient(topology, x));
}

/// The first element of a box of 2 x 3 x 5 with its corners moved out of their planes.
ElementVectors twisted(const Mesh& mesh) {
  ElementVectors x = gather(mesh.blocks()[0].element_nodes(0), mesh.coordinates());
  for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] += 0.1 * std::sin(3.0 * double(i));
  return x;
}

std::vector<Mesh> solids() {
  const Box box{.size = {2, 3, 5}};
  return {MeshBuilder().add_hexes(box).build(), MeshBuilder().add_tets(box).build(),
          MeshBuilder().add_ten_node_tets(box).build(), MeshBuilder().add_wedges(box).build(),
          MeshBuilder().add_pyramids(box).build()};
}

}  // namespace

TEST_CASE("the volumes of a box's elements add up to the box", "[core][output]") {
  for (const Mesh& mesh : solids()) {
    const ElementBlock& block = mesh.blocks()[0];
    double sum = 0.0;
    for (std::uint32_t e = 0; e < block.n_elements; ++e)
      sum += volume_of(topology(block.shape), gather(block.element_nodes(e), mesh.coordinates()));
    CHECK(sum == Approx(30.0));
  }
}

TEST_CASE("a volume far from the origin keeps its digits", "[core][output]") {
  const Mesh mesh = MeshBuilder().add_hexes({.origin = {1e6, -1e6, 1e6}}).build();
  const ElementBlock& block = mesh.blocks()[0];
  const ElementVectors x = gather(block.element_nodes(0), mesh.coordinates());
  CHECK(volume_of(topology(block.shape), x) == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("the gradient of a volume is its derivative", "[core][output]") {
  for (const Mesh& mesh : solids()) {
    const Topology& shape = topology(mesh.blocks()[0].shape);
    ElementVectors x = twisted(mesh);
    const ElementVectors gradient = volume_gradient(shape, x);
    // The volume is linear in each coordinate, so a difference is exact but for rounding.
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      ElementVectors moved = x;
      moved.data()[i] += 1.0;
      CHECK(volume_of(shape, moved) - volume_of(shape, x) == Approx(gradient.data()[i]).margin(1e-12));
    }
  }
}

TEST_CASE("mean gradients of a linear field are its gradient", "[core][output]") {
  Eigen::Matrix3d a;
  a << 1, 2, 3, 4, 5, 6, 7, 8, 10;
  for (const Mesh& mesh : solids()) {
    const ElementVectors x = twisted(mesh);
    const ElementVectors gradient = volume_gradient(topology(mesh.blocks()[0].shape), x);
    const Eigen::Matrix3d found = a * x * gradient.transpose() / solid_volume(x, gradient);
    CHECK((found - a).norm() < 1e-12);
  }
}
