// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/uniform_gradient.hpp"

namespace contactsim {

namespace {

/// Four-node tetrahedra; see base_vectors.hpp. Their gradients are uniform: there are no hourglass modes.
struct TetGeometry : NodeBase<4> {
  static constexpr std::size_t n_modes = 0;
  static constexpr double mode_norm = 1.0;  ///< of none

  static NodeVectors<4> volume_gradient(const NodeVectors<4>& x) {
    return {component(x[1], x[2]), component(x[2], x[0]), component(x[0], x[1])};
  }
  static std::array<Lanes, 0> mode_sums(const std::array<Lanes, 4>&) { return {}; }
  static void add_modes(const std::array<Lanes, 0>&, std::array<Lanes, 4>&) {}

 private:
  /// A sixth of the cross products of the edges from node 0; node 0 balances the others.
  static std::array<Lanes, 4> component(const std::array<Lanes, 4>& y, const std::array<Lanes, 4>& z) {
    std::array<Lanes, 4> u, w, gradient;
    for (std::size_t a = 1; a < 4; ++a) {
      u[a] = (y[a] - y[0]) * (1.0 / 6.0);
      w[a] = z[a] - z[0];
    }
    gradient[1] = u[2] * w[3] - w[2] * u[3];
    gradient[2] = u[3] * w[1] - w[3] * u[1];
    gradient[3] = u[1] * w[2] - w[1] * u[2];
    gradient[0] = -gradient[1] - gradient[2] - gradient[3];
    return gradient;
  }
};

}  // namespace

const ElementFormulation tet4_mean_quadrature = solid_element<UniformGradient<Shape::tet4, TetGeometry>>();

}  // namespace contactsim
