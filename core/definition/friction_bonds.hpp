// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "core/definition/condition_lines.hpp"

/// The friction models that hold what touches at the start until it fails. Their words are those of
/// friction.hpp: gap, slip, and pulls that are positive. Forces, unlike tractions, are those of one contact
/// point: a node, or a pair of faces.
namespace contactsim {

/// What a weld does once it fails: the force at that time fades along a straight line, while another model
/// acts already.
struct WeldFailure {
  std::int64_t decay_cycles = 1;         ///< steps until the force of the failure is gone, >= 1
  std::optional<DeckName> failed_model;  ///< absent: frictionless
  bool operator==(const WeldFailure&) const = default;
};

/// SPRING WELD MODEL: what touches at the start is held by two springs, one across the gap and one along the
/// slip. It fails when (gap / gap_max)^p + (slip / slip_max)^p >= 1, where the maxima are the last abscissas
/// of the two functions and p is the exponent.
struct SpringWeld {
  ScaledFunction normal, tangential;  ///< of the gap and of the slip [length] to force [force]
  double envelope_exponent = 2.0;     ///< > 0 [1]
  WeldFailure failure;
  bool operator==(const SpringWeld&) const = default;
};

/// SURFACE WELD MODEL (capacities are forces) and AREA WELD MODEL (tractions): tied until the force N across
/// the tie and T along it reach (N / normal_capacity)^2 + (T / tangential_capacity)^2 > 1; N is 0 in
/// compression.
struct SurfaceWeld {
  bool is_per_area = false;                                               ///< AREA WELD MODEL
  double normal_capacity = std::numeric_limits<double>::quiet_NaN();      ///< > 0 [force] or [force/length^2]
  double tangential_capacity = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force] or [force/length^2]
  WeldFailure failure;
  bool operator==(const SurfaceWeld&) const = default;
};

/// COHESIVE ZONE MODEL: what touches at the start is held by tractions that fail with gap and slip together.
/// With lambda = sqrt((gap / g_n)^2 + (slip / g_t)^2) and the function s(lambda), the normal traction is
/// s / lambda * gap / g_n and the tangential one s / lambda * (g_n / g_t) * slip / g_t. When lambda falls,
/// s goes back along a straight line to the origin; at lambda = 1 the place fails, then it is frictionless.
struct CohesiveZone {
  ScaledFunction traction;  ///< lambda [1] to traction [force/length^2]
  double critical_normal_gap = std::numeric_limits<double>::quiet_NaN();      ///< g_n > 0 [length]
  double critical_tangential_gap = std::numeric_limits<double>::quiet_NaN();  ///< g_t > 0 [length]
  bool operator==(const CohesiveZone&) const = default;
};

/// THREADED MODEL: what touches at the start is held by a traction across the gap and one along the slip; the
/// latter is multiplied by a factor that depends on the gap, as threads let go. It fails when
/// (N / normal_capacity)^p + (T / tangential_capacity)^p >= 1 of the two tractions, p the exponent.
struct Threaded {
  ScaledFunction normal;          ///< gap [length] to traction N [force/length^2]
  ScaledFunction tangential;      ///< slip [length] to traction T without its factor [force/length^2]
  ScaledFunction tangential_gap;  ///< gap [length] to the factor of T [1]; without a function it is 1
  double normal_capacity = std::numeric_limits<double>::quiet_NaN();      ///< > 0 [force/length^2]
  double tangential_capacity = std::numeric_limits<double>::quiet_NaN();  ///< > 0 [force/length^2]
  double envelope_exponent = 2.0;                                         ///< > 0 [1]
  WeldFailure failure;
  bool operator==(const Threaded&) const = default;
};

}  // namespace contactsim
