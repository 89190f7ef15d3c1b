// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "core/definition/condition_lines.hpp"

/// The friction models of a contact definition. In all of them a gap, and the force or traction that a
/// function gives for it, are positive when the surfaces are apart and pull each other.
/// Source: Sierra/SM 5.22, 8.5; laws past Coulomb's as in ACME's documentation.
namespace contactsim {

/// FRICTIONLESS MODEL: normal force only.
struct Frictionless {
  bool operator==(const Frictionless&) const = default;
};

/// CONSTANT FRICTION MODEL: the tangential force is at most coefficient * normal force (Coulomb).
struct ConstantFriction {
  double coefficient = 0.0;  ///< >= 0 [1]
  bool operator==(const ConstantFriction&) const = default;
};

/// TIED MODEL: what touches at the start does not move relative to each other.
struct Tied {
  bool operator==(const Tied&) const = default;
};

/// GLUED MODEL: frictionless until touched, tied from then on.
struct Glued {
  bool operator==(const Glued&) const = default;
};

/// What a weld does once it fails: its force fades linearly, then another model takes over.
struct WeldFailure {
  std::int64_t decay_cycles = 1;         ///< steps over which the force at failure fades, >= 1
  std::optional<DeckName> failed_model;  ///< absent: frictionless
  bool operator==(const WeldFailure&) const = default;
};

/// SPRING WELD MODEL: forces from the normal and tangential displacement; fails when
/// (u_n / u_n_max)^p + (u_t / u_t_max)^p >= 1, u_max the last abscissa of its function, p the exponent.
struct SpringWeld {
  ScaledFunction normal, tangential;  ///< displacement [length] to force [force]
  double envelope_exponent = 2.0;     ///< > 0 [1]
  WeldFailure failure;
  bool operator==(const SpringWeld&) const = default;
};

/// SURFACE WELD MODEL (capacities are forces) and AREA WELD MODEL (tractions): tied until
/// (N / normal)^2 + (T / tangential)^2 > 1, where N counts in tension only.
struct SurfaceWeld {
  bool is_per_area = false;                                               ///< AREA WELD MODEL
  double normal_capacity = std::numeric_limits<double>::quiet_NaN();      ///< > 0 [force] or [force/length^2]
  double tangential_capacity = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force] or [force/length^2]
  WeldFailure failure;
  bool operator==(const SurfaceWeld&) const = default;
};

/// ADHESION MODEL: frictionless in compression; apart, the traction is f(gap) up to f's last abscissa.
struct Adhesion {
  ScaledFunction adhesion;  ///< gap [length] to traction [force/length^2]
  bool operator==(const Adhesion&) const = default;
};

/// COHESIVE ZONE MODEL: with lambda = sqrt((u_n / g_n)^2 + (u_t / g_t)^2) and traction s(lambda), the normal
/// traction is s / lambda * u_n / g_n, the tangential one s / lambda * g_n / g_t * u_t / g_t.
struct CohesiveZone {
  ScaledFunction traction;  ///< lambda [1] to traction [force/length^2]
  double critical_normal_gap = std::numeric_limits<double>::quiet_NaN();      ///< g_n > 0 [length]
  double critical_tangential_gap = std::numeric_limits<double>::quiet_NaN();  ///< g_t > 0 [length]
  bool operator==(const CohesiveZone&) const = default;
};

/// JUNCTION MODEL: apart, the normal traction is f(gap); the tangential traction is at most g(slip rate), and
/// zero when the gap reaches the cutoff.
struct Junction {
  ScaledFunction normal;                    ///< gap [length] to traction [force/length^2]
  ScaledFunction tangential;                ///< slip rate [length/time] to traction [force/length^2]
  std::optional<double> tangential_cutoff;  ///< NORMAL CUTOFF DISTANCE FOR TANGENTIAL TRACTION >= 0 [length]
  bool operator==(const Junction&) const = default;
};

/// THREADED MODEL: springs in tension, and a failure envelope in the capacities.
struct Threaded {
  ScaledFunction normal;          ///< gap [length] to traction [force/length^2]
  ScaledFunction tangential;      ///< slip [length] to traction [force/length^2]
  ScaledFunction tangential_gap;  ///< gap [length] to the factor of the tangential traction [1]; absent: 1
  double normal_capacity = std::numeric_limits<double>::quiet_NaN();      ///< > 0 [force/length^2]
  double tangential_capacity = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force/length^2]
  double envelope_exponent = 2.0;                                         ///< > 0 [1]
  WeldFailure failure;
  bool operator==(const Threaded&) const = default;
};

/// PV_DEPENDENT MODEL: mu(v) = mu_d + (mu_s - mu_d) exp(-decay * v) at the slip rate v; the tangential
/// traction is at most mu(v) * ((p + offset) / reference)^exponent at the pressure p.
struct PressureVelocityFriction {
  double static_coefficient = 0.0;                                       ///< mu_s >= 0 [1]
  double dynamic_coefficient = 0.0;                                      ///< mu_d >= 0 [1]
  double velocity_decay = 0.0;                                           ///< >= 0 [time/length]
  double reference_pressure = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force/length^2]
  double offset_pressure = 0.0;                                          ///< >= 0 [force/length^2]
  double pressure_exponent = 1.0;                                        ///< [1]
  bool operator==(const PressureVelocityFriction&) const = default;
};

/// HYBRID MODEL: the model of a facet depends on whether it is close to the other side at the start.
struct HybridFriction {
  std::optional<DeckName> initially_close, initially_far;  ///< absent: frictionless
  bool operator==(const HybridFriction&) const = default;
};

/// MODEL = <model> DURING PERIODS <periods> of a TIME VARIANT MODEL.
struct PeriodModel {
  DeckName model;
  std::vector<DeckName> periods;
  bool operator==(const PeriodModel&) const = default;
};

/// TIME VARIANT MODEL: the model changes with the time stepping block.
struct TimeVariantFriction {
  std::vector<PeriodModel> models;  ///< frictionless in periods that none names
  bool operator==(const TimeVariantFriction&) const = default;
};

using FrictionLaw =
    std::variant<Frictionless, ConstantFriction, Tied, Glued, SpringWeld, SurfaceWeld, Adhesion, CohesiveZone,
                 Junction, Threaded, PressureVelocityFriction, HybridFriction, TimeVariantFriction>;

/// BEGIN ... MODEL <name>. Interactions use it by name.
struct FrictionModel {
  DeckName name;
  FrictionLaw law;
};

/// The law that a name stands for: the first model so called, else one of FRICTIONLESS and TIED, which need
/// no definition; null when there is none. The result lives as long as `models`.
const FrictionLaw* find_friction_law(std::span<const FrictionModel> models, std::string_view name);

}  // namespace contactsim
