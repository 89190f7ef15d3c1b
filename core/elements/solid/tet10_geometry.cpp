// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/solid/tet10_geometry.hpp"

#include <cstdint>

namespace contactsim::tet10 {

namespace {

constexpr std::size_t middle = 10;  // the node in the middle

/// One of the twelve by its nodes, and the means of psi in it: of its own point and of each other one.
struct SubTet {
  std::array<std::uint8_t, 4> nodes;
  std::uint8_t point;
  double own, other;
};

// psi_i = (lambda_i - b) / (a - b) with the barycentric coordinate lambda_i, a = (5 + 3 sqrt(5)) / 20 and
// b = (5 - sqrt(5)) / 20, the places of the four-point rule of degree two: psi_i psi_j has the integral V/4
// delta_ij where all edges are straight. Midside nodes: 4 of edge 01, 5: 12, 6: 20, 7: 03, 8: 13, 9: 23.
constexpr double at_others = 0.1381966011250105, slope = 1.0 / 0.4472135954999579;
constexpr double psi(double lambda) { return (lambda - at_others) * slope; }

constexpr SubTet at_corner(std::uint8_t corner, std::array<std::uint8_t, 4> nodes) {
  return {nodes, corner, psi(0.625), psi(0.125)};
}
/// On the inner side of the tetrahedron at a corner.
constexpr SubTet behind_corner(std::uint8_t corner, std::array<std::uint8_t, 4> nodes) {
  return {nodes, corner, psi(0.4375), psi(0.1875)};
}
/// On the middle of the face that is opposite to a corner.
constexpr SubTet on_face(std::uint8_t opposite, std::array<std::uint8_t, 4> nodes) {
  return {nodes, opposite, psi(0.0625), psi(0.3125)};
}

constexpr std::array sub_tets{at_corner(0, {0, 4, 6, 7}),          at_corner(1, {1, 5, 4, 8}),
                              at_corner(2, {2, 6, 5, 9}),          at_corner(3, {3, 8, 7, 9}),
                              behind_corner(0, {4, 6, 7, middle}), behind_corner(1, {4, 8, 5, middle}),
                              behind_corner(2, {6, 5, 9, middle}), behind_corner(3, {7, 9, 8, middle}),
                              on_face(3, {4, 5, 6, middle}),       on_face(2, {4, 7, 8, middle}),
                              on_face(0, {5, 8, 9, middle}),       on_face(1, {6, 9, 7, middle})};

/// A sixth of the cross products of the edges from node 0; node 0 balances the others.
std::array<Lanes, 4> tet_component(const std::array<Lanes, 11>& y, const std::array<Lanes, 11>& z,
                                   const std::array<std::uint8_t, 4>& nodes) {
  std::array<Lanes, 4> u, w, gradient;
  for (std::size_t a = 1; a < 4; ++a) {
    u[a] = (y[nodes[a]] - y[nodes[0]]) * (1.0 / 6.0);
    w[a] = z[nodes[a]] - z[nodes[0]];
  }
  gradient[1] = u[2] * w[3] - w[2] * u[3];
  gradient[2] = u[3] * w[1] - w[3] * u[1];
  gradient[3] = u[1] * w[2] - w[1] * u[2];
  gradient[0] = -gradient[1] - gradient[2] - gradient[3];
  return gradient;
}

/// The coordinates of all nodes, the one in the middle with them.
NodeVectors<11> with_middle(const NodeVectors<n_nodes>& x) {
  NodeVectors<11> all;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < n_nodes; ++a) all[i][a] = x[i][a];
    all[i][middle] = (x[i][4] + x[i][5] + x[i][6] + x[i][7] + x[i][8] + x[i][9]) * (1.0 / 6.0);
  }
  return all;
}

/// Volume of a sub-tetrahedron from its gradients.
Lanes sub_volume(const std::array<Lanes, 11>& x, const SubTet& tet, const std::array<Lanes, 4>& gradient) {
  const Lanes& origin = x[tet.nodes[0]];
  return (x[tet.nodes[1]] - origin) * gradient[1] + (x[tet.nodes[2]] - origin) * gradient[2] +
         (x[tet.nodes[3]] - origin) * gradient[3];
}

/// Sums of the gradients at two points over the nodes, each over the root of the volume and the mass, the
/// points mixed so that blocks off the diagonal are small: the first is their mean.
void mix(const Projection& projection, const Lanes& per_mass, std::array<NodeVectors<n_nodes>, n_points>& g) {
  std::array<Lanes, n_points> scale;
  for (std::size_t i = 0; i < n_points; ++i) scale[i] = 0.5 * (per_mass / projection.volume[i]).sqrt();
  const double corner = std::sqrt(1.0 / mass_shares[0]), midside = std::sqrt(1.0 / mass_shares[4]);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t a = 0; a < n_nodes; ++a) {
      std::array<Lanes, n_points> at;
      for (std::size_t i = 0; i < n_points; ++i)
        at[i] = projection.gradient[i][k][a] * scale[i] * (a < 4 ? corner : midside);
      const Lanes first = at[0] + at[1], last = at[2] + at[3];
      const Lanes turn = at[0] - at[1], twist = at[2] - at[3];
      g[0][k][a] = first + last;
      g[1][k][a] = first - last;
      g[2][k][a] = turn + twist;
      g[3][k][a] = turn - twist;
    }
  }
}

/// The Frobenius norm of a sum over nodes of two vectors' products.
Lanes norm_of_products(const NodeVectors<n_nodes>& a, const NodeVectors<n_nodes>& b) {
  Lanes sum = Lanes::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Lanes product = dot(a[i], b[j]);
      sum += product * product;
    }
  }
  return sum.sqrt();
}

}  // namespace

Projection::Projection(const NodeVectors<n_nodes>& x) {
  const NodeVectors<11> all = with_middle(x);
  NodeVectors<11> common;  // what all points get
  std::array<NodeVectors<11>, n_points> own;
  for (std::size_t i = 0; i < 3; ++i) {
    common[i].fill(Lanes::Zero());
    for (auto& at_point : own) at_point[i].fill(Lanes::Zero());
  }
  Lanes common_volume = Lanes::Zero();
  volume.fill(Lanes::Zero());
  whole_volume.setZero();
  bool is_first = true;
  for (const SubTet& tet : sub_tets) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<Lanes, 4> of_tet = tet_component(all[(i + 1) % 3], all[(i + 2) % 3], tet.nodes);
      for (std::size_t a = 0; a < 4; ++a) {
        common[i][tet.nodes[a]] += tet.other * of_tet[a];
        own[tet.point][i][tet.nodes[a]] += (tet.own - tet.other) * of_tet[a];
      }
      if (i > 0) continue;
      const Lanes sub = sub_volume(all[0], tet, of_tet);
      min_volume = is_first ? sub : Lanes(min_volume.min(sub));
      is_first = false;
      whole_volume += sub;
      common_volume += tet.other * sub;
      volume[tet.point] += (tet.own - tet.other) * sub;
    }
  }
  for (std::size_t p = 0; p < n_points; ++p) {
    volume[p] += common_volume;
    min_volume = min_volume.min(volume[p]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Lanes of_middle = (common[i][middle] + own[p][i][middle]) * (1.0 / 6.0);
      for (std::size_t a = 0; a < n_nodes; ++a) {
        gradient[p][i][a] = common[i][a] + own[p][i][a];
        if (a >= 4) gradient[p][i][a] += of_middle;
      }
    }
  }
}

Lanes bound_of_gradients(const Projection& projection, const Lanes& mass) {
  std::array<NodeVectors<n_nodes>, n_points> g;
  mix(projection, 1.0 / mass, g);
  std::array<Lanes, n_points> row;
  for (std::size_t p = 0; p < n_points; ++p) row[p] = bound_of_eigenvalues(squares(g[p]));
  for (std::size_t p = 0; p < n_points; ++p) {
    for (std::size_t q = p + 1; q < n_points; ++q) {
      const Lanes norm = norm_of_products(g[p], g[q]);
      row[p] += norm;
      row[q] += norm;
    }
  }
  return row[0].max(row[1]).max(row[2].max(row[3]));
}

Lanes volume(const NodeVectors<n_nodes>& x) { return Projection(x).volume_or_worst(); }

}  // namespace contactsim::tet10
