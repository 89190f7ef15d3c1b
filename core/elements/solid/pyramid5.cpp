// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/face_gradient.hpp"
#include "core/elements/solid/uniform_gradient.hpp"
#include "core/mesh/side_tables.hpp"

namespace contactsim {

namespace {

/// Mean quadrature of five-node pyramids; see base_vectors.hpp. The hourglass mode is that of the base,
/// orthogonal to linear fields when that is a parallelogram. Source: Belytschko and others, Comput. Meth.
/// Appl. Mech. Eng. 43 (1984) 251-276, for the quadrilateral.
struct PyramidGeometry : NodeBase<5> {
  static constexpr std::size_t n_modes = 1;
  static constexpr double mode_norm = 2.0;

  static NodeVectors<5> volume_gradient(const NodeVectors<5>& x) {
    return face_volume_gradient<side_tables::pyramid_sides>(x);
  }
  static std::array<Lanes, 1> mode_sums(const std::array<Lanes, 5>& v) { return {v[0] - v[1] + v[2] - v[3]}; }
  static void add_modes(const std::array<Lanes, 1>& amounts, std::array<Lanes, 5>& v) {
    v[0] += amounts[0];
    v[1] -= amounts[0];
    v[2] += amounts[0];
    v[3] -= amounts[0];
  }
};

}  // namespace

const ElementFormulation pyramid5_mean_quadrature =
    solid_element<UniformGradient<Shape::pyramid5, PyramidGeometry>>();

}  // namespace contactsim
