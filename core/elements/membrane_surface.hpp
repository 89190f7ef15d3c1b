// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell_kernel.hpp"

namespace contactsim {

/// A surface of shells as one of membranes, for the same kernel: nodes do not turn, and neither curvature nor
/// transverse shear is resisted. Of the patterns those of the membrane stay, which shells list first.
template <class Shell>
class MembraneSurface {
 public:
  static constexpr std::size_t n_nodes = Shell::n_nodes;
  static constexpr std::size_t n_patterns = Shell::n_membrane_patterns;
  static constexpr bool has_rotations = false;
  static constexpr auto kinds = [] {
    std::array<PatternKind, n_patterns> kinds{};
    kinds.fill(PatternKind::membrane);
    return kinds;
  }();
  using Rates = ShellRates<n_patterns>;

  ///   x  coordinates of the nodes [length]
  explicit MembraneSurface(const NodeVectors<n_nodes>& x) : shell_(x) {}

  const Lanes& area() const { return shell_.area(); }
  const TensorLanes& frame() const { return shell_.frame(); }
  auto gradients() const { return shell_.gradients(); }

  /// As Shell::rates of nodes that do not turn, the membrane's alone.
  Rates rates(const NodeVectors<n_nodes>& v, const NodeVectors<n_nodes>& /*w*/) const {
    const auto of_shell = shell_.rates(v, zero());
    Rates rates{of_shell.membrane, none<3>(), none<2>(), {}};
    for (std::size_t k = 0; k < n_patterns; ++k) rates.patterns[k] = of_shell.patterns[k];
    return rates;
  }

  /// As Shell::set_forces; sets no moments.
  void set_forces(const Rates& resistance, NodeVectors<n_nodes>& force, NodeVectors<n_nodes>& moment) const {
    typename Shell::Rates of_shell{resistance.membrane, none<3>(), none<2>(), none<Shell::n_patterns>()};
    for (std::size_t k = 0; k < n_patterns; ++k) of_shell.patterns[k] = resistance.patterns[k];
    shell_.set_forces(of_shell, force, moment);
  }

  ShellSizes sizes() const { return shell_.sizes(); }
  std::array<PatternSizes, n_patterns> pattern_sizes() const {
    const auto of_shell = shell_.pattern_sizes();
    std::array<PatternSizes, n_patterns> sizes;
    for (std::size_t k = 0; k < n_patterns; ++k) sizes[k] = of_shell[k];
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
