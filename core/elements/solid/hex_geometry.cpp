// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/hex_geometry.hpp"

namespace contactsim {

namespace {

/// Row I: the order in which the nodes stand in the formula of node 0 when it is written for node I.
constexpr std::size_t turned[8][8] = {
    {0, 1, 2, 3, 4, 5, 6, 7}, {1, 2, 3, 0, 5, 6, 7, 4}, {2, 3, 0, 1, 6, 7, 4, 5}, {3, 0, 1, 2, 7, 4, 5, 6},
    {4, 7, 6, 5, 0, 3, 2, 1}, {5, 4, 7, 6, 1, 0, 3, 2}, {6, 5, 4, 7, 2, 1, 0, 3}, {7, 6, 5, 4, 3, 2, 1, 0}};

/// One component of the gradient at one node, from the two other coordinates.
template <std::size_t node>
Lanes gradient_at(const std::array<Lanes, 8>& y, const std::array<Lanes, 8>& z) {
  constexpr const auto& n = turned[node];
  const Lanes z_24 = z[n[1]] - z[n[3]], z_25 = z[n[1]] - z[n[4]], z_45 = z[n[3]] - z[n[4]];
  return (y[n[1]] * (z[n[5]] - z[n[2]] - z_45) + y[n[2]] * z_24 + y[n[3]] * (z[n[2]] - z[n[7]] + z_25) +
          y[n[4]] * (z[n[7]] - z[n[5]] - z_24) - y[n[5]] * z_25 + y[n[7]] * z_45) *
         (1.0 / 12.0);
}

void set_component(const std::array<Lanes, 8>& y, const std::array<Lanes, 8>& z,
                   std::array<Lanes, 8>& component) {
  component[0] = gradient_at<0>(y, z);
  component[1] = gradient_at<1>(y, z);
  component[2] = gradient_at<2>(y, z);
  component[3] = gradient_at<3>(y, z);
  component[4] = gradient_at<4>(y, z);
  component[5] = gradient_at<5>(y, z);
  component[6] = gradient_at<6>(y, z);
  component[7] = gradient_at<7>(y, z);
}

}  // namespace

NodeVectors<8> HexGeometry::volume_gradient(const NodeVectors<8>& x) {
  NodeVectors<8> gradient;
  set_component(x[1], x[2], gradient[0]);
  set_component(x[2], x[0], gradient[1]);
  set_component(x[0], x[1], gradient[2]);
  return gradient;
}

// The hourglass modes are products of the signs of the natural coordinates, so that sums and differences of
// pairs are shared: first along zeta (nodes 0..3 below 4..7), then within the two quadrilaterals.
std::array<Lanes, 4> HexGeometry::mode_sums(const std::array<Lanes, 8>& v) {
  const Lanes s0 = v[0] + v[4], s1 = v[1] + v[5], s2 = v[2] + v[6], s3 = v[3] + v[7];
  const Lanes d0 = v[4] - v[0], d1 = v[5] - v[1], d2 = v[6] - v[2], d3 = v[7] - v[3];
  return {d2 + d3 - d0 - d1, d1 + d2 - d0 - d3, s0 - s1 + s2 - s3, d0 - d1 + d2 - d3};
}

void HexGeometry::add_modes(const std::array<Lanes, 4>& a, std::array<Lanes, 8>& v) {
  const Lanes sum = a[0] + a[1], difference = a[0] - a[1];
  const Lanes even = a[2] + a[3], odd = a[2] - a[3];  // of the mode xi eta, above and below
  v[0] += sum + odd;
  v[1] += difference - odd;
  v[2] += odd - sum;
  v[3] -= difference + odd;
  v[4] += even - sum;
  v[5] -= difference + even;
  v[6] += sum + even;
  v[7] += difference - even;
}

}  // namespace contactsim
