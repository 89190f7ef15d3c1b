// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/point_in_solid.hpp"

#include <random>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The elements of a mesh that hold a point.
int count_holders(const Mesh& mesh, const Eigen::Vector3d& point) {
  int n = 0;
  for (const ElementBlock& block : mesh.blocks()) {
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      Eigen::Matrix3Xd corners(3, block.element_nodes(e).size());
      for (Eigen::Index k = 0; k < corners.cols(); ++k)
        corners.col(k) = mesh.coordinates().col(block.element_nodes(e)[static_cast<std::size_t>(k)].value);
      n += is_in_solid(corners, topology(block.shape), point) ? 1 : 0;
    }
  }
  return n;
}

/// A block of 3 x 3 x 3 cells of some shape, its nodes inside moved about so that faces are warped.
Mesh warped_block(int shape) {
  const test::Box box{.id = 1, .cells = {3, 3, 3}};
  MeshBuilder b;
  if (shape == 0) b.add_hexes(box);
  if (shape == 1) b.add_tets(box);
  if (shape == 2) b.add_wedges(box);
  if (shape == 3) b.add_pyramids(box);
  const Mesh straight = b.build();
  Eigen::Matrix3Xd x = straight.coordinates();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.05, 0.05);
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const bool is_within = x.col(i).minCoeff() > 0.01 && x.col(i).maxCoeff() < 0.99;
    if (is_within) x.col(i) += Eigen::Vector3d(shift(random), shift(random), shift(random));
  }
  return straight.with_coordinates(x);
}

}  // namespace

TEST_CASE("every point of a block is in one of its elements, whatever their shape", "[contact][overlap]") {
  const Mesh mesh = warped_block(GENERATE(0, 1, 2, 3));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> entity(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d point(entity(random), entity(random), entity(random));
    INFO(point.transpose());
    CHECK(count_holders(mesh, point) == 1);
    CHECK(count_holders(mesh, point + Eigen::Vector3d(0, 1.0, 0)) == 0);
  }
}

TEST_CASE("a point on a wall belongs to the elements on both sides", "[contact][overlap]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {2, 1, 1}}).build();
  CHECK(count_holders(mesh, {0.5, 0.3, 0.6}) == 2);
  CHECK(count_holders(mesh, {0.0, 0.3, 0.6}) == 1);
  CHECK(count_holders(mesh, {-1e-6, 0.3, 0.6}) == 0);
}
