// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/base/lanes.hpp"
#include "core/materials/hardening.hpp"

/// The way back to a yield surface that grows along a curve, from where an elastic step would have ended.
namespace contactsim {

/// How a step would end were it elastic, in a solid.
struct SolidTrial {
  Lanes equivalent;   ///< stress, relative to the back stress [force/length^2]
  const Lanes& eqps;  ///< equivalent plastic strain at the start [1]
  double shear;       ///< modulus [force/length^2]
  double dt;          ///< [time]
};

/// The same in a shell or a fibre: the square of the equivalent stress in two parts, which fall by
/// 1 / (1 + a g)^2 and 1 / (1 + b g)^2 as g, the flow strain over stress, grows.
struct PlaneTrial {
  Lanes sum_part, difference_part;  ///< [force^2/length^4]
  double a, b;                      ///< > 0, without hardening [force/length^2]
  const Lanes& eqps;                ///< equivalent plastic strain at the start [1]
  double dt;                        ///< [time]
};

/// What flows in a step.
///   Modulus  double or Lanes
template <class Modulus>
struct PlasticFlow {
  Lanes increment;    ///< of the equivalent plastic strain, 0 where the step is elastic [1]
  Modulus kinematic;  ///< growth of the back stress by that [force/length^2]
};

/// The same where stresses fall at different rates.
template <class Modulus>
struct PlaneFlow {
  Lanes flow;         ///< strain over stress [length^2/force]
  Lanes increment;    ///< of the equivalent plastic strain [1]
  Modulus kinematic;  ///< growth of the back stress by the flow over the stress at the end [force/length^2]
};

/// The way back along the radius: exactly, from point to point of the curve, on each of whose lines the yield
/// condition is linear. Nothing where all lanes are elastic.
std::optional<PlasticFlow<Lanes>> return_to(const MultilinearHardening& hardening, const SolidTrial& trial);

/// The same without stress across a shell or a fibre. With r the radius of the yield surface at the start and
/// h the growth of the curve, the plastic increment x must satisfy
///   1 = sum_part / (r + h(x) + 3/2 a x)^2 + difference_part / (r + h(x) + 3/2 b x)^2,
/// whichever part of h the back stress takes. The right side falls with x, so points of the curve where it
/// exceeds 1 are passed; on the line after them Newton's method for its inverse square root, which is
/// concave, rises to the root without passing it, up to round-off. Source: Simo and Taylor, Int. J. Numer.
/// Meth. Eng. 22 (1986) 649-670; Reinsch, Numer. Math. 16 (1971) 451-454, for the inverse root.
std::optional<PlaneFlow<Lanes>> return_to(const MultilinearHardening& hardening, const PlaneTrial& trial);

}  // namespace contactsim
