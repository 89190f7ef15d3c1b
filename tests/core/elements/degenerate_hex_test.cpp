// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra that name nodes more than once: wedges, pyramids and tetrahedra in the guise of a hexahedron.
#include "core/dynamics/internal_force.hpp"
#include "core/mesh/element_checks.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;

namespace {

/// The eight corners of the hexahedron that is another shape.
struct Collapse {
  Shape shape;
  std::vector<std::uint32_t> corners;
};

const Collapse collapses[] = {{Shape::wedge6, {0, 1, 2, 2, 3, 4, 5, 5}},
                              {Shape::pyramid5, {0, 1, 2, 3, 4, 4, 4, 4}},
                              {Shape::tet4, {0, 1, 2, 2, 3, 3, 3, 3}}};

template <class Check>
void for_each_collapse(const Check& check) {
  for (const ElementFormulation* row : solid_elements()) {
    if (row->shape != Shape::hex8) continue;
    for (const Collapse& collapse : collapses) {
      INFO(name_of(*row) << " as " << topology(collapse.shape).name);
      check(*row, collapse);
    }
  }
}

/// A box of such hexahedra with its inner nodes moved at random.
Mesh collapsed_patch(const Collapse& collapse) {
  MeshBuilder builder;
  const Box box{.cells = {2, 2, 2}};
  if (collapse.shape == Shape::wedge6) builder.add_wedges(box);
  if (collapse.shape == Shape::pyramid5) builder.add_pyramids(box);
  if (collapse.shape == Shape::tet4) builder.add_tets(box);
  MeshParts parts = builder.parts();
  ElementBlock& block = parts.blocks[0];
  std::vector<NodeIndex> nodes;
  for (std::uint32_t element = 0; element < block.n_elements; ++element) {
    for (const std::uint32_t corner : collapse.corners) nodes.push_back(block.element_nodes(element)[corner]);
  }
  block.shape = Shape::hex8;
  block.nodes_per_element = 8;
  block.nodes = std::move(nodes);
  const Matrix3Xd moved = distorted(parts.coordinates, 0.05, 3);
  for (Eigen::Index node = 0; node < moved.cols(); ++node) {
    const auto x = parts.coordinates.col(node);
    if (x.minCoeff() > 0.0 && x.maxCoeff() < 1.0) parts.coordinates.col(node) = moved.col(node);
  }
  return Mesh(std::move(parts));
}

LoneElement collapsed_element(const ElementFormulation& row, const Collapse& collapse, unsigned seed) {
  const Matrix3Xd x = distorted(regular_element(collapse.shape), 0.1, seed);
  return {row, undamped_elastic(), x, collapse.corners};
}

}  // namespace

TEST_CASE("a patch of degenerate hexahedra deforms uniformly and stays in balance", "[core][elements]") {
  for_each_collapse([](const ElementFormulation& row, const Collapse& collapse) {
    const Mesh mesh = collapsed_patch(collapse);
    Model model;
    model.mesh = &mesh;
    model.blocks.push_back(make_solid_block(mesh, 0, row, undamped_elastic()));
    const ModelBlock& block = model.blocks[0];
    CHECK(lumped_mass(mesh, model.blocks).sum() == Approx(7800.0).epsilon(1e-13));
    State state = make_state(mesh.coordinates(), model.blocks, 0.0);
    InternalForce internal(model, state);
    const Matrix3d gradient = 1e-3 * Matrix3d{{0.6, 0.3, -0.2}, {-0.1, -0.5, 0.4}, {0.5, 0.2, 0.3}};
    const Matrix3Xd v = gradient * mesh.coordinates(), x = mesh.coordinates() + v;
    Matrix3Xd forces(3, x.cols());
    internal.set_forces({0.0, 1.0, x, v}, forces);
    const double stress = std::abs(state.blocks[0].at(block.layout, 0, 0));
    CHECK(stress > 1e7);
    for (std::size_t element = 0; element < block.n_elements; ++element) {
      for (std::size_t place = 0; place < row.n_points * 6; ++place) {
        const double first = state.blocks[0].at(block.layout, 0, place % 6);
        CHECK(std::abs(state.blocks[0].at(block.layout, element, place) - first) <= 1e-10 * stress);
      }
    }
    for (Eigen::Index node = 0; node < x.cols(); ++node) {
      const auto rest = mesh.coordinates().col(node);
      const bool is_inner = rest.minCoeff() > 0.0 && rest.maxCoeff() < 1.0;
      if (is_inner) CHECK(forces.col(node).norm() < 1e-10 * stress);
    }
  });
}

TEST_CASE("degenerate hexahedra are stable at their stable step, balance and turn freely",
          "[core][elements]") {
  for_each_collapse([](const ElementFormulation& row, const Collapse& collapse) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      LoneElement element = collapsed_element(row, collapse, seed);
      CHECK(element.stay().stable_step <= (1.0 + 1e-6) * stable_limit(element));
      CHECK(element.stay().stable_step >= 0.3 * stable_limit(element));
      const Matrix3Xd x = element.coordinates;
      for (int i = 1; i <= 4; ++i) element.move_to(rotation_of(0.3 * i) * x);
      CHECK(element.forces().norm() < 1e-3);  // of moduli near 1e11
      element.move_to(distorted(element.coordinates, 0.01, 2));
      CHECK(element.forces().norm() > 1e7);
      CHECK(element.forces().rowwise().sum().norm() < 1e-12 * element.forces().norm());
    }
  });
}
