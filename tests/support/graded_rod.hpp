// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "core/dynamics/model.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// A rod of hexahedra along x of cross-section 1, modulus 1 and density 1 without lateral contraction: the
/// speed of sound is 1. Blocks of large, small and large elements share nodes.
struct GradedRod {
  struct Sizes {
    int n_large = 40;  ///< at each end
    int n_small = 2;
    double small_size = 0.1;  ///< of large ones
    double bulk_viscosity = 0.0;
  };

  explicit GradedRod(const Sizes& sizes) : mesh(make_mesh(sizes)) {
    model.mesh = &mesh;
    const ElementProperties properties{ElasticLaw{{1.0 / 3.0, 0.5}}, 1.0, 0.05, 0.0,
                                       sizes.bulk_viscosity,         0.0};
    for (std::uint32_t b = 0; b < 3; ++b)
      model.blocks.push_back(make_solid_block(mesh, b, hex8_mean_quadrature, properties));
    model.mass = lumped_mass(mesh, model.blocks);
    for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) steps.push_back(length_of(i));
  }
  GradedRod(const GradedRod&) = delete;
  GradedRod& operator=(const GradedRod&) = delete;

  /// Subcycles what is smaller than the large elements, and layers around it.
  void subcycle() {
    const SubcycledSet set(model, steps, 1.0);
    model.subcycles = set.sums();
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
      split_chunks(mesh, set.batches()[b], model.blocks[b]);
  }

  double length_of(std::uint32_t element) const {
    const auto nodes = mesh.element_nodes(ElementIndex{element});
    return mesh.coordinates()(0, nodes[1].value) - mesh.coordinates()(0, nodes[0].value);
  }

  static Mesh make_mesh(const Sizes& sizes) {
    const double large = sizes.n_large, small = sizes.n_small * sizes.small_size;
    return MeshBuilder()
        .add_hexes({.id = 1, .cells = {sizes.n_large, 1, 1}, .size = {large, 1, 1}})
        .add_hexes({.id = 2, .cells = {sizes.n_small, 1, 1}, .origin = {large, 0, 0}, .size = {small, 1, 1}})
        .add_hexes(
            {.id = 3, .cells = {sizes.n_large, 1, 1}, .origin = {large + small, 0, 0}, .size = {large, 1, 1}})
        .build();
  }

  Mesh mesh;
  Model model;
  std::vector<double> steps;  ///< [n_elements] length / speed of sound [time]
};

}  // namespace contactsim::test
