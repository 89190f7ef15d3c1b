// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/shell_kernel.hpp"

namespace contactsim {

/// A surface of shells as one of membranes, for the same kernel: nodes do not turn, and neither curvature nor
/// transverse shear is resisted. Of the hourglass modes those of the membrane stay, which shells list first.
template <class Shell>
class MembraneSurface {
 public:
  static constexpr std::size_t n_nodes = Shell::n_nodes;
  static constexpr std::size_t n_modes = Shell::n_membrane_modes;
  static constexpr bool has_rotations = false;
  static constexpr auto kinds = [] {
    std::array<HourglassKind, n_modes> kinds{};
    kinds.fill(HourglassKind::membrane);
    return kinds;
  }();
  using Rates = ShellRates<n_modes>;

  ///   x  coordinates of the nodes [length]
  explicit MembraneSurface(const NodeVectors<n_nodes>& x) : shell_(x) {}

  const Lanes& area() const { return shell_.area(); }
  const TensorLanes& frame() const { return shell_.frame(); }
  auto gradients() const { return shell_.gradients(); }

  /// As Shell::rates of nodes that do not turn, the membrane's alone.
  Rates rates(const NodeVectors<n_nodes>& v, const NodeVectors<n_nodes>& /*w*/) const {
    const auto shell_values = shell_.rates(v, zero());
    Rates rates{shell_values.membrane, none<3>(), none<2>(), {}};
    for (std::size_t k = 0; k < n_modes; ++k) rates.hourglass[k] = shell_values.hourglass[k];
    return rates;
  }

  /// As Shell::set_forces; sets no moments.
  void set_forces(const Rates& resistance, NodeVectors<n_nodes>& force, NodeVectors<n_nodes>& moment) const {
    typename Shell::Rates shell_values{resistance.membrane, none<3>(), none<2>(), none<Shell::n_modes>()};
    for (std::size_t k = 0; k < n_modes; ++k) shell_values.hourglass[k] = resistance.hourglass[k];
    shell_.set_forces(shell_values, force, moment);
  }

  ShellSizes sizes() const { return shell_.sizes(); }
  std::array<HourglassSizes, n_modes> hourglass_sizes() const {
    const auto shell_values = shell_.hourglass_sizes();
    std::array<HourglassSizes, n_modes> sizes;
    for (std::size_t k = 0; k < n_modes; ++k) sizes[k] = shell_values[k];
    return sizes;
  }

  /// What the warp of a four-node surface is, see QuadShell: without it tension would not flatten it.
  auto warp() const requires requires(const Shell& shell) { shell.warp(); }
  { return shell_.warp(); }

 private:
  template <std::size_t n>
  static std::array<Lanes, n> none() {
    std::array<Lanes, n> values;
    for (Lanes& value : values) value.setZero();
    return values;
  }
  static NodeVectors<n_nodes> zero() { return {none<n_nodes>(), none<n_nodes>(), none<n_nodes>()}; }

  Shell shell_;
};

}  // namespace contactsim
