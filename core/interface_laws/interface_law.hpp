// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/functions/function.hpp"
#include "core/interface_laws/bond_law.hpp"
#include "core/interface_laws/law_curve.hpp"
#include "core/interface_laws/pressure_law.hpp"

namespace contactsim {

/// How the sides of a pair hold each other, as far as the loops over contact points need to know. welded:
/// ties that can fail; what none holds slides.
enum class ContactLaw : std::uint8_t { sliding, glued, tied, welded };

/// Tangential traction across a gap, at most g(slip rate), at gaps below the cutoff.
struct RateLimit {
  Function traction;    ///< of the slip rate
  double scale = 1.0;   ///< of the function [1]
  double cutoff = 0.0;  ///< [length]
};

/// A tie that fails at an envelope of its force, or of its traction.
struct WeldLaw {
  bool is_per_area = false;
  double normal_capacity = 0.0, tangential_capacity = 0.0;  ///< [force] or [force/length^2]
};

/// The largest tangential force of a contact point that touches [force].
///   force  normal, >= 0
///   area   [length^2]
///   speed  slip rate, >= 0 [length/time]
using SlipLimit = std::function<double(double force, double area, double speed)>;

/// A friction model, ready for the loops over contact points: what limits the force along the surface, what
/// pulls across a gap, and what holds the sides together from the start.
struct InterfaceLaw {
  ContactLaw law = ContactLaw::sliding;
  double friction = 0.0;  ///< Coulomb's coefficient; more than 0 where `limit` is the limit [1]
  SlipLimit limit;        ///< empty: Coulomb's
  std::optional<RateLimit> rate_limit;
  std::optional<LawCurve> pull;  ///< gap [length] to traction [force/length^2], up to its last abscissa
  std::optional<PressureLaw> pressure;  ///< in place of the penalty
  std::optional<BondLaw> bond_law;
  std::optional<WeldLaw> weld;
  std::int64_t decay_cycles = 1;  ///< steps over which what holds decays once it has failed

  /// Gaps up to this one feel the law [length].
  double activation_distance() const {
    return std::max(pull ? pull->last() : 0.0, rate_limit ? rate_limit->cutoff : 0.0);
  }
  /// Whether it holds the sides together, if only until it fails.
  bool holds() const { return law != ContactLaw::sliding || bond_law || weld; }
  /// Whether it pushes, with friction, and nothing else.
  bool only_pushes() const { return !holds() && !pull && !rate_limit; }
  /// Whether its friction is Coulomb's and nothing acts besides, but for ties.
  bool is_simple() const { return !limit && !rate_limit && !pull && !pressure && !bond_law && !weld; }
  /// Whether it is that but for a pressure of its own.
  bool only_presses() const { return pressure && !limit && only_pushes(); }
  /// As SlipLimit.
  double slip_limit(double force, double area, double speed) const {
    return limit ? limit(force, area, speed) : friction * force;
  }
};

}  // namespace contactsim
