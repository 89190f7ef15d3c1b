// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/shell/triangle_shell.hpp"

#include "core/elements/shell/surface_pair.hpp"

namespace contactsim {

namespace {

SurfacePair operator-(const SurfacePair& a, const SurfacePair& b) { return {a[0] - b[0], a[1] - b[1]}; }

/// A vector of the second or third node less that of the first.
VectorLanes difference(const NodeVectors<3>& v, std::size_t node) {
  return {v[0][node] - v[0][0], v[1][node] - v[1][0], v[2][node] - v[2][0]};
}

VectorLanes sum(const NodeVectors<3>& v) {
  return {v[0][0] + v[0][1] + v[0][2], v[1][0] + v[1][1] + v[1][2], v[2][0] + v[2][1] + v[2][2]};
}

/// Sets vectors that go with the sum over the nodes and with the differences to the first.
void spread(const VectorLanes& all, const VectorLanes& second, const VectorLanes& third,
            NodeVectors<3>& nodes) {
  for (std::size_t i = 0; i < 3; ++i)
    nodes[i] = {all[i] - second[i] - third[i], all[i] + second[i], all[i] + third[i]};
}

}  // namespace

TriangleShell::TriangleShell(const NodeVectors<3>& x) {
  const VectorLanes a = difference(x, 1), b = difference(x, 2), normal = cross(a, b);
  const Lanes size = dot(normal, normal).sqrt();
  area_ = 0.5 * size;
  frame_[0] = unit(a);
  frame_[2] = scaled(normal, 1.0 / size);
  frame_[1] = cross(frame_[2], frame_[0]);
  for (std::size_t i = 0; i < 2; ++i) {
    a_[i] = dot(frame_[i], a);
    b_[i] = dot(frame_[i], b);
  }
  // The gradients g2, g3 of the shape functions: g2 . a = g3 . b = 1, g2 . b = g3 . a = 0.
  const Lanes per_size = 1.0 / size;
  xi_ = {b_[1] * per_size, -b_[0] * per_size};
  eta_ = {-a_[1] * per_size, a_[0] * per_size};
}

TriangleShell::EdgeRows TriangleShell::edge_rows() const {
  const SurfacePair c = a_ - b_;
  EdgeRows rows;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      rows.first[i][j] = (1.0 / 6.0) * (xi_[i] * c[j] - eta_[i] * b_[j]);
      rows.second[i][j] = (-1.0 / 6.0) * (xi_[i] * a_[j] + eta_[i] * c[j]);
    }
  }
  return rows;
}

TriangleShell::Rates TriangleShell::rates(const NodeVectors<3>& v, const NodeVectors<3>& w) const {
  const VectorLanes va = to_local(frame_, difference(v, 1)), vb = to_local(frame_, difference(v, 2));
  const SurfacePair psi = tip(to_local(frame_, sum(w))), psi_a = tip(to_local(frame_, difference(w, 1))),
                    psi_b = tip(to_local(frame_, difference(w, 2)));
  const EdgeRows rows = edge_rows();
  // With u_i the velocity and p_i that of the normal's tip: strain u_(i,j), curvature p_(i,j), both with xy
  // twice the tensor's, shear u_3,i + mean p_i + what the edges add.
  Rates rates;
  rates.membrane = {xi_[0] * va[0] + eta_[0] * vb[0], xi_[1] * va[1] + eta_[1] * vb[1],
                    xi_[1] * va[0] + eta_[1] * vb[0] + xi_[0] * va[1] + eta_[0] * vb[1]};
  rates.curvature = {xi_[0] * psi_a[0] + eta_[0] * psi_b[0], xi_[1] * psi_a[1] + eta_[1] * psi_b[1],
                     xi_[1] * psi_a[0] + eta_[1] * psi_b[0] + xi_[0] * psi_a[1] + eta_[0] * psi_b[1]};
  for (std::size_t i = 0; i < 2; ++i) {
    rates.shear[i] = xi_[i] * va[2] + eta_[i] * vb[2] + (1.0 / 3.0) * psi[i];
    for (std::size_t j = 0; j < 2; ++j)
      rates.shear[i] += rows.first[i][j] * psi_a[j] + rows.second[i][j] * psi_b[j];
  }
  rates.hourglass[0] = 0.5 * (dot(b_, psi_a) - dot(a_, psi_b));
  return rates;
}

void TriangleShell::set_forces(const Rates& r, NodeVectors<3>& force, NodeVectors<3>& moment) const {
  const EdgeRows rows = edge_rows();
  VectorLanes fa, fb, none;
  SurfacePair on_psi, on_psi_a, on_psi_b;
  constexpr std::size_t at[2][2] = {{0, 2}, {2, 1}};
  for (std::size_t i = 0; i < 2; ++i) {
    fa[i] = -(r.membrane[at[i][0]] * xi_[0] + r.membrane[at[i][1]] * xi_[1]);
    fb[i] = -(r.membrane[at[i][0]] * eta_[0] + r.membrane[at[i][1]] * eta_[1]);
    on_psi[i] = (-1.0 / 3.0) * r.shear[i];
    on_psi_a[i] =
        -(r.curvature[at[i][0]] * xi_[0] + r.curvature[at[i][1]] * xi_[1] + rows.first[0][i] * r.shear[0] +
          rows.first[1][i] * r.shear[1] + 0.5 * r.hourglass[0] * b_[i]);
    on_psi_b[i] =
        -(r.curvature[at[i][0]] * eta_[0] + r.curvature[at[i][1]] * eta_[1] + rows.second[0][i] * r.shear[0] +
          rows.second[1][i] * r.shear[1] - 0.5 * r.hourglass[0] * a_[i]);
  }
  fa[2] = -(r.shear[0] * xi_[0] + r.shear[1] * xi_[1]);
  fb[2] = -(r.shear[0] * eta_[0] + r.shear[1] * eta_[1]);
  for (Lanes& component : none) component.setZero();
  spread(none, to_global(frame_, fa), to_global(frame_, fb), force);
  spread(to_global(frame_, moment_of(on_psi, none[0])), to_global(frame_, moment_of(on_psi_a, none[0])),
         to_global(frame_, moment_of(on_psi_b, none[0])), moment);
}

std::array<std::array<Lanes, 3>, 2> TriangleShell::gradients() const {
  return {{{-xi_[0] - eta_[0], xi_[0], eta_[0]}, {-xi_[1] - eta_[1], xi_[1], eta_[1]}}};
}

ShellSizes TriangleShell::sizes() const {
  ShellSizes sizes;
  sizes.area = area_;
  const SurfacePair first{-xi_[0] - eta_[0],
                          -xi_[1] - eta_[1]};  // gradient of the first node's shape function
  sizes.gram = {first[0] * first[0] + xi_[0] * xi_[0] + eta_[0] * eta_[0],
                first[1] * first[1] + xi_[1] * xi_[1] + eta_[1] * eta_[1],
                first[0] * first[1] + xi_[0] * xi_[1] + eta_[0] * eta_[1]};
  sizes.warp = sizes.tilt = Lanes::Zero();
  const EdgeRows rows = edge_rows();
  sizes.shear_by_turning = Lanes::Constant(1.0 / 3.0);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      const Lanes u = rows.first[i][j], w = rows.second[i][j];
      sizes.shear_by_turning += u * u + w * w + (u + w) * (u + w);
    }
  }
  return sizes;
}

std::array<HourglassSizes, TriangleShell::n_modes> TriangleShell::hourglass_sizes() const {
  const SurfacePair c = a_ - b_;
  return {
      {{Lanes::Zero(), 0.25 * (dot(a_, a_) + dot(b_, b_) + dot(c, c)), 4.0 / 3.0 * sizes().gram_trace()}}};
}

}  // namespace contactsim
