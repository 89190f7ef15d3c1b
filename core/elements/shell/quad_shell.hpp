// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/membrane_tension.hpp"
#include "core/elements/shell/shell_kernel.hpp"
#include "core/elements/shell_frame.hpp"

namespace contactsim {

/// Four-node shells with one point of integration in their surface, at some time. With xi and eta the
/// natural coordinates, a node's coordinates are those of the middle + (xi a + eta b + xi eta c) / 4: in the
/// frame a and b have no z, and c has what the surface is warped.
///
/// Rates in the middle, those of fibres through the nodes that stand on the warped surface, so that a rigid
/// motion of any such shell has none; a turning of fibres about themselves has none either. Transverse shear
/// is that along the edges, averaged: a uniform curvature of any shape has none. Source: Belytschko, Lin and
/// Tsay, Comp. Meth. Appl. Mech. Eng. 42 (1984) 225-251; Belytschko, Wong and Chiang, same 96 (1992) 93-107;
/// shear: Bathe and Dvorkin, Int. J. Numer. Meth. Eng. 21 (1985) 367-383.
class QuadShell {
 public:
  static constexpr std::size_t n_nodes = 4, n_modes = 6, n_membrane_modes = 2;
  static constexpr bool has_rotations = true;
  static constexpr std::array<HourglassKind, n_modes> kinds{HourglassKind::membrane, HourglassKind::membrane,
                                                            HourglassKind::bending,  HourglassKind::bending,
                                                            HourglassKind::shear,    HourglassKind::shear};
  using Rates = ShellRates<n_modes>;

  ///   x  coordinates of the nodes [length]
  explicit QuadShell(const NodeVectors<4>& x);

  const Lanes& area() const { return area_; }
  /// Rows are the unit vectors along x, y and z.
  const TensorLanes& frame() const { return frame_; }

  ///   v, w  velocities and angular velocities of the nodes [length/time], [1/time]
  Rates rates(const NodeVectors<4>& v, const NodeVectors<4>& w) const;

  /// Sets what resists the rates on the nodes: the transpose of `rates`, with the other sign.
  void set_forces(const Rates& resistance, NodeVectors<4>& force, NodeVectors<4>& moment) const;

  /// Of the shape functions along x and y [1/length].
  std::array<std::array<Lanes, 4>, 2> gradients() const;

  shells::SurfaceWarp warp() const;
  ShellSizes sizes() const;
  std::array<HourglassSizes, n_modes> hourglass_sizes() const;

 private:
  TensorLanes frame_;
  std::array<Lanes, 2> a_, b_, c_;  ///< in the surface
  Lanes z_;  ///< height of the nodes over the plane, in turn up and down: a quarter of c
  std::array<Lanes, 2> xi_, eta_;  ///< gradients of the natural coordinates in the middle
  std::array<Lanes, 3> bend_;      ///< curvature of the surface: xx, yy, xy
  std::array<Lanes, 3> slant_;     ///< z (xi xi + eta eta): how slopes at the nodes differ: xx, yy, xy
  Lanes area_;
};

}  // namespace contactsim
