// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "contact/interface_laws/law_curve.hpp"
#include "core/conditions/active_times.hpp"
#include "core/definition/friction_pressure.hpp"
#include "core/functions/function.hpp"

/// Friction models, ready for the loops over contact points. A model is made of up to three parts: what
/// limits the force along the surface, what pulls across a gap, and what holds interfaces together from the
/// start.
namespace contactsim {

/// How the sides of a pair hold each other, as far as the loops over contact points need to know. welded:
/// ties that can fail; what none holds slides.
enum class ContactLaw : std::uint8_t { sliding, glued, tied, welded };

/// Tangential traction of a junction, at most g(slip rate), at gaps below the cutoff.
struct RateLimit {
  Function traction;    ///< of the slip rate
  double scale = 1.0;   ///< of the function [1]
  double cutoff = 0.0;  ///< [length]
};

/// The forces of a spring weld; it fails at the envelope of displacements.
struct SpringWeldLaw {
  LawCurve normal, tangential;  ///< displacement [length] to force [force]
  double exponent = 2.0;        ///< [1]
};

/// The tractions of a threaded joint; it fails at the envelope of tractions.
struct ThreadedJointLaw {
  LawCurve normal, tangential;     ///< displacement [length] to traction [force/length^2]
  std::optional<Function> by_gap;  ///< factor of the tangential traction [1]
  double by_gap_scale = 1.0;
  double normal_capacity = 0.0, tangential_capacity = 0.0;  ///< [force/length^2]
  double exponent = 2.0;                                    ///< [1]
};

/// A cohesive zone. Source: Tvergaard and Hutchinson, J. Mech. Phys. Solids 41 (1993) 1119-1135; unloading to
/// the origin as in Camacho and Ortiz, Int. J. Solids Struct. 33 (1996) 2899-2938.
struct CohesiveLaw {
  LawCurve traction;                                        ///< lambda [1] to traction [force/length^2]
  double critical_normal = 0.0, critical_tangential = 0.0;  ///< [length]
};

/// A tie that fails at an envelope of its force, or of its traction.
struct WeldLaw {
  bool is_per_area = false;
  double normal_capacity = 0.0, tangential_capacity = 0.0;  ///< [force] or [force/length^2]
};

using BondLaw = std::variant<SpringWeldLaw, ThreadedJointLaw, CohesiveLaw, WeldLaw>;

/// A friction model that is more than frictionless, constant friction, tied or glued.
struct InterfaceLaw {
  ContactLaw law = ContactLaw::sliding;
  double friction = 0.0;  ///< Coulomb's coefficient; 1 where `pressure_velocity` is the limit [1]
  std::optional<PressureVelocityFriction> pressure_velocity;
  std::optional<RateLimit> rate_limit;
  std::optional<LawCurve> pull;     ///< gap [length] to traction [force/length^2], up to its last abscissa
  std::optional<BondLaw> bond_law;  ///< of what is near at the start
  std::int64_t decay_cycles = 1;    ///< steps over which what holds decays once it has failed

  /// Gaps up to this one feel the law [length].
  double activation_distance() const;
  /// Whether it pushes, with friction, and nothing else.
  bool only_pushes() const { return law == ContactLaw::sliding && !pull && !rate_limit && !bond_law; }
  bool is_weld() const { return bond_law && std::holds_alternative<WeldLaw>(*bond_law); }
  /// The largest tangential force of a contact point that touches [force].
  ///   force  normal, >= 0
  ///   area   [length^2]
  ///   speed  slip rate, >= 0 [length/time]
  double slip_limit(double force, double area, double speed) const;
};

/// The friction model of a pair: one, one by whether the sides were close at the start, or one by period.
struct PairInterfaceLaw {
  struct Period {
    ActiveTimes times;
    std::shared_ptr<const InterfaceLaw> law;
  };
  std::shared_ptr<const InterfaceLaw> law;  ///< HYBRID: where the sides were close at the start
  std::shared_ptr<const InterfaceLaw> far;  ///< HYBRID: elsewhere; else null
  std::vector<Period> periods;              ///< TIME VARIANT; frictionless in none of them

  bool is_variant() const { return !periods.empty(); }
  /// Calls a function with every model that the pair may have.
  template <class Visit>
  void visit_models(const Visit& visit) const {
    if (law) visit(*law);
    if (far) visit(*far);
    for (const Period& period : periods) visit(*period.law);
  }
};

}  // namespace contactsim
