// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/shell_stiffness.hpp"
#include "core/elements/shell_frame.hpp"

/// Resistance of fibres that turn about themselves otherwise than the surface around them does: at each node
/// a moment about the normal, elastic in the angle between the two, and the forces that balance it.
/// Source: Hughes and Brezzi, Comp. Meth. Appl. Mech. Eng. 72 (1989) 105-121, with one point.
namespace contactsim::shells {

/// How fast the fibres at the nodes turn about the normal, less how fast the surface does [1/time].
///   v, w  velocities and angular velocities of the nodes [length/time], [1/time]
template <class Geometry, std::size_t n = Geometry::n_nodes>
std::array<Lanes, n> drilling_rates(const Geometry& geometry, const NodeVectors<n>& v,
                                    const NodeVectors<n>& w) {
  const auto gradients = geometry.gradients();
  std::array<Lanes, n> rates;
  Lanes spin = Lanes::Zero();
  for (std::size_t a = 0; a < n; ++a) {
    const VectorLanes local = to_local(geometry.frame(), {v[0][a], v[1][a], v[2][a]});
    spin += 0.5 * (gradients[0][a] * local[1] - gradients[1][a] * local[0]);
    rates[a] = dot(geometry.frame()[2], {w[0][a], w[1][a], w[2][a]});
  }
  for (Lanes& rate : rates) rate -= spin;
  return rates;
}

/// Adds what moments against the rates do to the nodes.
///   moments  [n_nodes] [force length]
template <class Geometry, std::size_t n = Geometry::n_nodes>
void add_drilling(const Geometry& geometry, std::span<const Lanes> moments, NodeVectors<n>& force,
                  NodeVectors<n>& moment) {
  const auto gradients = geometry.gradients();
  const TensorLanes& frame = geometry.frame();
  Lanes half = Lanes::Zero();
  for (const Lanes& at_node : moments) half += 0.5 * at_node;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t a = 0; a < n; ++a) {
      force[i][a] += half * (gradients[0][a] * frame[1][i] - gradients[1][a] * frame[0][i]);
      moment[i][a] -= moments[a] * frame[2][i];
    }
  }
}

/// Brings the moments to the end of a step; returns the work on them.
///   stiffness          of each node [force length]
///   moments            [n_nodes] [force length]
///   frequency_squared  what they add to the bound is added [1/time^2]
template <class Geometry, std::size_t n = Geometry::n_nodes>
Lanes resist_drilling(const Geometry& geometry, const ShellMotion<n>& motion, const Lanes& stiffness,
                      std::span<Lanes> moments, Lanes& frequency_squared) {
  const auto rates = drilling_rates(geometry, motion.v, motion.w);
  Lanes work = Lanes::Zero(), slopes = Lanes::Zero();
  for (std::size_t a = 0; a < n; ++a) {
    const Lanes growth = motion.dt * stiffness * rates[a];
    moments[a] += growth;
    work += motion.dt * rates[a] * (moments[a] - 0.5 * growth);
  }
  for (const auto& component : geometry.gradients()) slopes += 0.25 * dot(component, component);
  frequency_squared += stiffness * static_cast<double>(n) *
                       (1.0 / motion.inertia + static_cast<double>(n) * slopes / motion.mass);
  return work;
}

}  // namespace contactsim::shells
