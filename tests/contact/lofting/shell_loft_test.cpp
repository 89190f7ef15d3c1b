// SPDX-License-Identifier: BSD-3-Clause
#include "contact/lofting/shell_loft.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr double rounding = 1e-12;

/// The neighbours of all elements, which are shells.
class AllShells {
 public:
  explicit AllShells(Mesh mesh) : mesh_(std::move(mesh)) {
    for (std::uint32_t e = 0; e < mesh_.n_elements(); ++e) elements_.push_back({e});
  }
  ShellNeighbours neighbours() const { return ShellNeighbours(mesh_, mesh_.coordinates(), elements_); }

 private:
  Mesh mesh_;
  std::vector<ElementIndex> elements_;
};

Eigen::Vector3d corner_normal(const ShellNeighbours& neighbours, std::uint32_t shell, int corner) {
  return neighbours.mean_normal(neighbours.around(shell, corner));
}

/// Two unit shells that share the edge x = 1; the second is turned about it by the angle, upwards.
AllShells folded(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  MeshBuilder b;
  b.add_shells({.id = 1});
  b.add_shells({.id = 2, .origin = {1, 0, 0}, .u = {std::cos(angle), 0, std::sin(angle)}});
  return AllShells(b.build());
}

}  // namespace

TEST_CASE("the normal at a fold is the mean of both shells' normals", "[contact][loft]") {
  // Normals (0,0,1) and (-sin a, 0, cos a): the mean leans by half the angle.
  const double degrees = GENERATE(0.0, 10.0, 59.0);
  const AllShells shells = folded(degrees);
  const ShellNeighbours neighbours = shells.neighbours();
  const double half = degrees / 2 * std::numbers::pi / 180;
  const Eigen::Vector3d expected(-std::sin(half), 0, std::cos(half));
  CHECK((corner_normal(neighbours, 0, 1) - expected).norm() < rounding);  // corners 1, 2 of the first
  CHECK((corner_normal(neighbours, 0, 2) - expected).norm() < rounding);
  CHECK((corner_normal(neighbours, 1, 0) - expected).norm() < rounding);  // corners 0, 3 of the second
  CHECK((corner_normal(neighbours, 1, 3) - expected).norm() < rounding);
  CHECK((corner_normal(neighbours, 0, 0) - Eigen::Vector3d::UnitZ()).norm() < rounding);
}

TEST_CASE("beyond sixty degrees each shell keeps its normal", "[contact][loft]") {
  const AllShells shells = folded(GENERATE(61.0, 90.0, 119.0));
  CHECK((corner_normal(shells.neighbours(), 0, 1) - Eigen::Vector3d::UnitZ()).norm() < rounding);
}

TEST_CASE("a shell folded back by more than 120 degrees counts with its normal turned", "[contact][loft]") {
  // At 180 degrees the second shell lies on the first, looking down.
  const AllShells shells = folded(180);
  CHECK((corner_normal(shells.neighbours(), 0, 1) - Eigen::Vector3d::UnitZ()).norm() < rounding);
  CHECK((corner_normal(shells.neighbours(), 1, 0) + Eigen::Vector3d::UnitZ()).norm() < rounding);
}

TEST_CASE("larger shells weigh more in the mean normal", "[contact][loft]") {
  // A triangle of area 1/2 with normal z beside a quadrilateral of area 2 with normal (-0.6, 0, 0.8):
  // (0,0,0.5) + (-1.2,0,1.6) = (-1.2, 0, 2.1).
  MeshBuilder b;
  b.add_shells({.id = 1, .origin = {1, 0, 0}, .u = {1.6, 0, 1.2}});
  const Mesh one = b.build();
  const auto quad = one.element_nodes({0});
  const NodeIndex tip = b.add_node({0, 0, 0});
  b.add_block(2, "", Shape::shell3, {tip.value, quad[0].value, quad[3].value});
  const AllShells shells(b.build());
  const Eigen::Vector3d expected = Eigen::Vector3d(-1.2, 0, 2.1) / std::sqrt(1.2 * 1.2 + 2.1 * 2.1);
  CHECK((corner_normal(shells.neighbours(), 0, 0) - expected).norm() < rounding);
  CHECK((corner_normal(shells.neighbours(), 1, 1) - expected).norm() < rounding);
}

TEST_CASE("an edge is on the perimeter when no other shell has it", "[contact][loft]") {
  const AllShells shells = folded(30);
  const ShellNeighbours neighbours = shells.neighbours();
  const auto edges = [&](std::uint32_t shell) {
    std::vector<bool> is_free;
    for (int edge = 0; edge < 4; ++edge) is_free.push_back(neighbours.is_perimeter(shell, edge));
    return is_free;
  };
  CHECK(edges(0) == std::vector<bool>{true, false, true, true});
  CHECK(edges(1) == std::vector<bool>{true, true, true, false});
}

TEST_CASE("a shared node or a shared diagonal is no shared edge", "[contact][loft]") {
  // The triangle 0 2 4 stands on the diagonal of the quadrilateral 0 1 2 3.
  MeshBuilder b;
  for (const Eigen::Vector3d& x :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 1, 0),
        Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
    b.add_node(x);
  }
  b.add_block(1, "", Shape::shell4, {0, 1, 2, 3});
  b.add_block(2, "", Shape::shell3, {0, 2, 4});
  const AllShells shells(b.build());
  const ShellNeighbours neighbours = shells.neighbours();
  for (int edge = 0; edge < 4; ++edge) CHECK(neighbours.is_perimeter(0, edge));
  for (int edge = 0; edge < 3; ++edge) CHECK(neighbours.is_perimeter(1, edge));
}

TEST_CASE("shells on one another share all their edges", "[contact][loft]") {
  MeshBuilder b;
  b.add_shells({.id = 1});
  b.add_block(2, "", Shape::shell4, {1, 0, 2, 3});  // the same nodes, turned over
  const AllShells shells(b.build());
  const ShellNeighbours neighbours = shells.neighbours();
  for (int edge = 0; edge < 4; ++edge) {
    CHECK_FALSE(neighbours.is_perimeter(0, edge));
    CHECK_FALSE(neighbours.is_perimeter(1, edge));
  }
}

TEST_CASE("the doubled edge of a degenerate shell is its own, a point is no edge", "[contact][loft]") {
  // The first quadrilateral is a triangle with its last node twice, the second is folded onto one edge.
  MeshBuilder b;
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                   Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(5, 0, 0)}) {
    b.add_node(x);
  }
  b.add_block(1, "", Shape::shell4, {0, 1, 2, 2, 3, 1, 1, 3});
  const AllShells shells(b.build());
  const ShellNeighbours neighbours = shells.neighbours();
  const auto edges = [&](std::uint32_t shell) {
    std::vector<bool> is_free;
    for (int edge = 0; edge < 4; ++edge) is_free.push_back(neighbours.is_perimeter(shell, edge));
    return is_free;
  };
  CHECK(edges(0) == std::vector<bool>{true, true, false, true});
  CHECK(edges(1) == std::vector<bool>{true, false, true, false});
}

TEST_CASE("the hub of a large fan is not smoothed", "[contact][loft]") {
  // A cone of triangles from the tip (0,0,1) down to the circle z = 1/2. Its normals lean by atan(1/2), two
  // opposite ones by 53 degrees, so at the tip all are taken and the mean looks up.
  const std::uint32_t n = GENERATE(256u, 257u);
  MeshBuilder b;
  b.add_node({0, 0, 1});
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    b.add_node({std::cos(angle), std::sin(angle), 0.5});
    nodes.insert(nodes.end(), {0, 1 + i, 1 + (i + 1) % n});
  }
  const AllShells shells(b.add_block(1, "", Shape::shell3, nodes).build());
  const ShellNeighbours neighbours = shells.neighbours();
  const Eigen::Vector3d at_tip = corner_normal(neighbours, 0, 0);
  const double own_z = 2 / std::sqrt(5.0);
  CHECK(at_tip.z() == Approx(n == 256 ? 1.0 : own_z).epsilon(1e-4));  // a chord is that near the circle
}
