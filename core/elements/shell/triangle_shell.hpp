// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/shell_kernel.hpp"
#include "core/elements/shell_frame.hpp"

namespace contactsim {

/// Three-node shells at some time: uniform strain and curvature, transverse shear from that along the
/// edges, of which a uniform curvature has none. The edges' shear has a part that no uniform shear fits; it
/// is an hourglass mode. x lies along the first edge. Source: Kennedy, Belytschko and Lin, Nucl. Eng. Des. 97
/// (1986) 1-24; shear: Lee and Bathe, Computers and Structures 82 (2004) 945-962.
class TriangleShell {
 public:
  static constexpr std::size_t n_nodes = 3, n_modes = 1, n_membrane_modes = 0;
  static constexpr bool has_rotations = true;
  static constexpr std::array<HourglassKind, n_modes> kinds{HourglassKind::shear};
  using Rates = ShellRates<n_modes>;

  ///   x  coordinates of the nodes [length]
  explicit TriangleShell(const NodeVectors<3>& x);

  const Lanes& area() const { return area_; }
  /// Rows are the unit vectors along x, y and z.
  const TensorLanes& frame() const { return frame_; }

  ///   v, w  velocities and angular velocities of the nodes [length/time], [1/time]
  Rates rates(const NodeVectors<3>& v, const NodeVectors<3>& w) const;

  /// Sets what resists the rates on the nodes: the transpose of `rates`, with the other sign.
  void set_forces(const Rates& resistance, NodeVectors<3>& force, NodeVectors<3>& moment) const;

  /// Of the shape functions along x and y [1/length].
  std::array<std::array<Lanes, 3>, 2> gradients() const;

  ShellSizes sizes() const;
  std::array<HourglassSizes, n_modes> hourglass_sizes() const;

 private:
  /// Rows of shear, beyond the mean, by the differences of fibres along the edges: [rate][component].
  struct EdgeRows {
    Lanes first[2][2], second[2][2];
  };
  EdgeRows edge_rows() const;

  TensorLanes frame_;
  std::array<Lanes, 2> a_, b_;     ///< from the first node to the second and to the third
  std::array<Lanes, 2> xi_, eta_;  ///< gradients of the shape functions of the second node and the third
  Lanes area_;
};

}  // namespace contactsim
