// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/face_gradient.hpp"
#include "core/elements/solid/uniform_gradient.hpp"
#include "core/mesh/side_tables.hpp"

namespace contactsim {

namespace {

/// Mean quadrature of six-node wedges; see base_vectors.hpp. The hourglass modes turn the two triangles
/// against each other: the two fields on a triangle without a mean, one way below and the other way above.
/// They are orthogonal to linear fields on prisms. Source: Belytschko and others, Comput. Meth. Appl. Mech.
/// Eng. 43 (1984) 251-276, for the idea; the hourglass modes by hand.
struct WedgeGeometry : NodeBase<6> {
  static constexpr std::size_t n_modes = 2;
  static constexpr double mode_norm = 2.0;

  static NodeVectors<6> volume_gradient(const NodeVectors<6>& x) {
    return face_volume_gradient<side_tables::wedge_sides>(x);
  }
  static std::array<Lanes, 2> mode_sums(const std::array<Lanes, 6>& v) {
    const Lanes d0 = v[0] - v[3], d1 = v[1] - v[4], d2 = v[2] - v[5];
    return {d0 - d1, (d0 + d1 - 2.0 * d2) * per_root_3};
  }
  static void add_modes(const std::array<Lanes, 2>& amounts, std::array<Lanes, 6>& v) {
    const Lanes second = amounts[1] * per_root_3, twice = 2.0 * second;
    const Lanes at_0 = second + amounts[0], at_1 = second - amounts[0];
    v[0] += at_0;
    v[1] += at_1;
    v[2] -= twice;
    v[3] -= at_0;
    v[4] -= at_1;
    v[5] += twice;
  }

 private:
  static constexpr double per_root_3 = 0.57735026918962573;  // both modes are equally long
};

}  // namespace

const ElementFormulation wedge6_mean_quadrature =
    solid_element<UniformGradient<Shape::wedge6, WedgeGeometry>>();

}  // namespace contactsim
