// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/shell/quad_shell.hpp"

#include "core/elements/shell/surface_pair.hpp"

namespace contactsim {

namespace {

/// Vectors at the nodes as multiples of 1, xi, eta and xi eta: each sums them with the signs of one of these.
struct Modes {
  VectorLanes all, a, b, c;

  explicit Modes(const NodeVectors<4>& v) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Lanes low = v[i][0] + v[i][1], high = v[i][2] + v[i][3];
      const Lanes right = v[i][1] - v[i][0], left = v[i][2] - v[i][3];
      all[i] = low + high;
      b[i] = high - low;
      a[i] = right + left;
      c[i] = left - right;
    }
  }
};

/// Component xx, yy, xy of a symmetric tensor of the surface.
constexpr std::size_t at(std::size_t i, std::size_t j) { return i == j ? i : 2; }

}  // namespace

/// The frame lies as evenly as can be to the lines that join the middles of opposite edges, whichever node
/// comes first.
QuadShell::QuadShell(const NodeVectors<4>& x) {
  const Modes modes(x);
  const VectorLanes normal = cross(modes.a, modes.b), along_a = unit(modes.a), along_b = unit(modes.b);
  const Lanes size = dot(normal, normal).sqrt();
  area_ = 0.25 * size;
  VectorLanes sum, difference;
  for (std::size_t i = 0; i < 3; ++i) {
    sum[i] = along_a[i] + along_b[i];
    difference[i] = along_a[i] - along_b[i];
  }
  sum = unit(sum);
  difference = unit(difference);
  constexpr double half_root = 0.70710678118654752;
  for (std::size_t i = 0; i < 3; ++i) {
    frame_[0][i] = half_root * (sum[i] + difference[i]);
    frame_[1][i] = half_root * (sum[i] - difference[i]);
  }
  frame_[2] = scaled(normal, 1.0 / size);
  for (std::size_t i = 0; i < 2; ++i) {
    a_[i] = dot(frame_[i], modes.a);
    b_[i] = dot(frame_[i], modes.b);
    c_[i] = dot(frame_[i], modes.c);
  }
  z_ = 0.25 * dot(frame_[2], modes.c);
  const Lanes per_area = 1.0 / area_;
  xi_ = {b_[1] * per_area, -b_[0] * per_area};
  eta_ = {-a_[1] * per_area, a_[0] * per_area};
  constexpr std::size_t first[3] = {0, 1, 0}, second[3] = {0, 1, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = first[k], j = second[k];
    bend_[k] = z_ * (xi_[i] * eta_[j] + eta_[i] * xi_[j]);
    slant_[k] = z_ * (xi_[i] * xi_[j] + eta_[i] * eta_[j]);
  }
}

QuadShell::Rates QuadShell::rates(const NodeVectors<4>& velocities,
                                  const NodeVectors<4>& angular_velocities) const {
  const Modes v(velocities), w(angular_velocities);
  const VectorLanes va = to_local(frame_, v.a), vb = to_local(frame_, v.b), vc = to_local(frame_, v.c);
  const VectorLanes w0 = to_local(frame_, w.all), wc = to_local(frame_, w.c);
  const SurfacePair psi = tip(w0), psi_a = tip(to_local(frame_, w.a)), psi_b = tip(to_local(frame_, w.b)),
                    psi_c = tip(wc);
  Rates rates;
  Lanes gradient[2][2], bending[2][2];  // of velocities and of fibres
  const Lanes c_psi_a = dot(c_, psi_a), c_psi_b = dot(c_, psi_b);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      gradient[i][j] = 0.25 * (xi_[j] * va[i] + eta_[j] * vb[i]);
      bending[i][j] = 0.25 * (xi_[j] * psi_a[i] + eta_[j] * psi_b[i]);
    }
    const Lanes slope = 0.25 * (xi_[i] * va[2] + eta_[i] * vb[2]);
    rates.shear[i] = slope + 0.25 * psi[i] + 0.0625 * (xi_[i] * c_psi_b + eta_[i] * c_psi_a);
    rates.hourglass[i] = vc[i] - c_[0] * gradient[i][0] - c_[1] * gradient[i][1] + 4.0 * z_ * slope;
    rates.hourglass[2 + i] = psi_c[i] - c_[0] * bending[i][0] - c_[1] * bending[i][1];
  }
  const Lanes c_psi = dot(c_, psi);
  rates.hourglass[4] = -vc[2] - 0.25 * (c_psi + dot(a_, psi_b));
  rates.hourglass[5] = vc[2] + 0.25 * (c_psi + dot(b_, psi_a));
  rates.membrane = {gradient[0][0], gradient[1][1], gradient[0][1] + gradient[1][0]};
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t i = 0; i < 2; ++i)
      bending[i][j] += gradient[i][0] * bend_[at(0, j)] + gradient[i][1] * bend_[at(1, j)];
    bending[0][j] += 0.25 * (bend_[at(j, 1)] * w0[2] + slant_[at(j, 1)] * wc[2]);
    bending[1][j] -= 0.25 * (bend_[at(j, 0)] * w0[2] + slant_[at(j, 0)] * wc[2]);
  }
  rates.curvature = {bending[0][0], bending[1][1], bending[0][1] + bending[1][0]};
  return rates;
}

namespace {

/// Adds or takes a vector at each node with the signs of its mode.
void spread(const VectorLanes& all, const VectorLanes& a, const VectorLanes& b, const VectorLanes& c,
            NodeVectors<4>& nodes) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Lanes low = all[i] - b[i], high = all[i] + b[i], left = c[i] - a[i], right = c[i] + a[i];
    nodes[i] = {low + left, low - left, high + right, high - right};
  }
}

}  // namespace

void QuadShell::set_forces(const Rates& r, NodeVectors<4>& force, NodeVectors<4>& moment) const {
  Lanes on_gradient[2][2], on_bending[2][2];
  VectorLanes fa, fb, fc, none;
  SurfacePair on_psi, on_psi_a, on_psi_b, on_psi_c;
  SurfacePair on_slope;
  Lanes about_normal = Lanes::Zero(), about_normal_c = Lanes::Zero();
  const Lanes across_xi = 0.0625 * dot(xi_, r.shear), across_eta = 0.0625 * dot(eta_, r.shear);
  const Lanes on_edges = 0.25 * (r.hourglass[5] - r.hourglass[4]);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      on_gradient[i][j] = r.membrane[at(i, j)] - r.hourglass[i] * c_[j] +
                          r.curvature[at(i, 0)] * bend_[at(j, 0)] + r.curvature[at(i, 1)] * bend_[at(j, 1)];
      on_bending[i][j] = r.curvature[at(i, j)] - r.hourglass[2 + i] * c_[j];
    }
    about_normal += r.curvature[at(0, i)] * bend_[at(i, 1)] - r.curvature[at(1, i)] * bend_[at(i, 0)];
    about_normal_c += r.curvature[at(0, i)] * slant_[at(i, 1)] - r.curvature[at(1, i)] * slant_[at(i, 0)];
    on_slope[i] = r.shear[i] + 4.0 * z_ * r.hourglass[i];
  }
  for (std::size_t i = 0; i < 2; ++i) {
    fa[i] = -0.25 * (on_gradient[i][0] * xi_[0] + on_gradient[i][1] * xi_[1]);
    fb[i] = -0.25 * (on_gradient[i][0] * eta_[0] + on_gradient[i][1] * eta_[1]);
    fc[i] = -r.hourglass[i];
    on_psi[i] = -0.25 * r.shear[i] - on_edges * c_[i];
    on_psi_a[i] = -0.25 * (on_bending[i][0] * xi_[0] + on_bending[i][1] * xi_[1] + r.hourglass[5] * b_[i]) -
                  across_eta * c_[i];
    on_psi_b[i] = -0.25 * (on_bending[i][0] * eta_[0] + on_bending[i][1] * eta_[1] - r.hourglass[4] * a_[i]) -
                  across_xi * c_[i];
    on_psi_c[i] = -r.hourglass[2 + i];
  }
  fa[2] = -0.25 * dot(on_slope, xi_);
  fb[2] = -0.25 * dot(on_slope, eta_);
  fc[2] = r.hourglass[4] - r.hourglass[5];
  for (Lanes& component : none) component.setZero();
  spread(none, to_global(frame_, fa), to_global(frame_, fb), to_global(frame_, fc), force);
  const Lanes zero = Lanes::Zero();
  spread(to_global(frame_, moment_of(on_psi, -0.25 * about_normal)),
         to_global(frame_, moment_of(on_psi_a, zero)), to_global(frame_, moment_of(on_psi_b, zero)),
         to_global(frame_, moment_of(on_psi_c, -0.25 * about_normal_c)), moment);
}

std::array<std::array<Lanes, 4>, 2> QuadShell::gradients() const {
  std::array<std::array<Lanes, 4>, 2> gradients;
  for (std::size_t i = 0; i < 2; ++i) {
    const Lanes sum = 0.25 * (xi_[i] + eta_[i]), difference = 0.25 * (xi_[i] - eta_[i]);
    gradients[i] = {-sum, difference, sum, -difference};
  }
  return gradients;
}

shells::SurfaceWarp QuadShell::warp() const {
  shells::SurfaceWarp warp;
  warp.height = 4.0 * z_;
  const auto rows = gradients();
  for (std::size_t a = 0; a < 4; ++a)
    warp.mode[a] = (a % 2 == 0 ? 1.0 : -1.0) - c_[0] * rows[0][a] - c_[1] * rows[1][a];
  warp.slopes = {xi_[0] * xi_[0] + eta_[0] * eta_[0], xi_[1] * xi_[1] + eta_[1] * eta_[1],
                 xi_[0] * xi_[1] + eta_[0] * eta_[1]};
  return warp;
}

/// The rows of shear by fibres are those of their mean, of norm 1/2, and a part that grows with c.
ShellSizes QuadShell::sizes() const {
  ShellSizes sizes;
  sizes.area = area_;
  sizes.gram = {0.25 * (xi_[0] * xi_[0] + eta_[0] * eta_[0]), 0.25 * (xi_[1] * xi_[1] + eta_[1] * eta_[1]),
                0.25 * (xi_[0] * xi_[1] + eta_[0] * eta_[1])};
  sizes.warp = (bend_[0] * bend_[0] + bend_[1] * bend_[1] + 2.0 * bend_[2] * bend_[2]).sqrt();
  sizes.tilt = 8.0 * z_ * z_ * sizes.gram_trace();
  const Lanes row = 0.5 + 0.25 * (dot(c_, c_) * sizes.gram_trace()).sqrt();
  sizes.shear_by_turning = row * row;
  return sizes;
}

std::array<HourglassSizes, QuadShell::n_modes> QuadShell::hourglass_sizes() const {
  const ShellSizes shell_sizes = sizes();
  const Lanes zero = Lanes::Zero(), four = Lanes::Constant(4.0), cc = dot(c_, c_);
  const Lanes norm = 4.0 + c_[0] * c_[0] * shell_sizes.gram[0] + c_[1] * c_[1] * shell_sizes.gram[1] +
                     2.0 * c_[0] * c_[1] * shell_sizes.gram[2];
  const Lanes per_norm = 1.0 / norm;
  const Lanes moving = norm + 16.0 * z_ * z_ * shell_sizes.gram_eigenvalue();
  return {{{moving, zero, per_norm},
           {zero, zero, per_norm},
           {zero, norm, per_norm},
           {zero, zero, per_norm},
           {four, 0.25 * (dot(a_, a_) + cc), dot(xi_, xi_)},
           {four, 0.25 * (dot(b_, b_) + cc), dot(eta_, eta_)}}};
}

}  // namespace contactsim
