// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/materials/hardening_curve.hpp"
#include "core/materials/hardening_row.hpp"
#include "core/materials/plastic_law.hpp"

namespace contactsim {

/// Flow stress along a curve, of whose growth a back stress takes a part.
/// Source: Sierra/SM, MULTILINEAR_EP; Simo and Hughes, Computational Inelasticity (1998), box 3.1.
struct MultilinearHardening {
  HardeningCurve curve;  ///< of the flow stress under growing load
  double beta = 1.0;     ///< share of isotropic hardening, 0 to 1 [1]
  static constexpr bool has_back_stress = true;
  static constexpr std::array variables = plastic_strain_and_back_stress;

  /// Radius of the yield surface where the curve has come to a stress [force/length^2].
  Lanes radius(const Lanes& stress) const { return (1.0 - beta) * curve.first_stress() + beta * stress; }
  FlowStress at(const Lanes& eqps, const Lanes& increment, double /*dt*/) const {
    const HardeningCurve::Place place = curve.at(eqps + increment);
    return {radius(place.stress), beta * place.slope};
  }
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

extern template struct PlasticLaw<MultilinearHardening>;

/// The lines of the curve.
std::vector<Parameter> multilinear_parameters();

HardeningRow multilinear_hardening();

/// The law of the parameters of multilinear_hardening(); as MakeMaterialLaw.
std::optional<PlasticLaw<MultilinearHardening>> make_multilinear_law(const MaterialInput& input);

}  // namespace contactsim
