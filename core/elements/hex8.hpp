// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/hex_geometry.hpp"
#include "core/materials/laws.hpp"

namespace contactsim {

/// What a block's section, its material and the region say of its hexahedra.
struct HexParameters {
  double density = 0.0;                   ///< of the undeformed material, > 0 [mass/length^3]
  double hourglass_stiffness = 0.05;      ///< >= 0 [1]
  double hourglass_viscosity = 0.0;       ///< >= 0 [1]
  double linear_bulk_viscosity = 0.06;    ///< >= 0 [1]
  double quadratic_bulk_viscosity = 1.2;  ///< >= 0 [1]
};

/// How eight hexahedra move in a step.
struct HexMotion {
  HexVectors x;   ///< coordinates at the end of the step [length]
  HexVectors v;   ///< velocities at its middle [length/time]
  Lanes mass;     ///< of the elements [mass]
  double dt = 0;  ///< size of the step, > 0 [time]
};

/// What eight hexahedra of a law remember.
template <class Law>
struct HexState {
  SymmetricLanes stress = SymmetricLanes::zero();  ///< Cauchy [force/length^2]
  std::array<std::array<Lanes, 4>, 3> hourglass;   ///< generalised forces [component][pattern] [force]
  std::array<Lanes, Law::n_state> material;

  HexState() {
    for (auto& component : hourglass) component.fill(Lanes::Zero());
    material.fill(Lanes::Zero());
  }
};

/// What a step gives.
struct HexStep {
  HexVectors force;      ///< internal force at the end of the step [force]
  Lanes volume;          ///< at the end of the step [length^3]
  Lanes stable_step;     ///< [time]
  Lanes hourglass_work;  ///< done on the hourglass forces in the step [energy]
  Lanes viscous_work;    ///< done on the bulk viscosity in the step [energy]
};

/// Brings eight mean-quadrature hexahedra to the end of a step. Strain from the gradient at the middle of the
/// step, stress turned by Hughes and Winget, hourglass resistance that vanishes for every linear velocity
/// field, linear and quadratic bulk viscosity. A volume that is not positive leaves numbers without meaning:
/// look at `volume`. stable_step is 2 / omega (sqrt(1 + z^2) - z), with z the share of bulk viscosity in
/// critical damping, and
///   omega^2 <= 8 / (m V) (lambda B:B + 2 mu e(B B^T) + k B:B),
/// a bound for the element's frequencies (e the largest eigenvalue; by Cauchy-Schwarz, term by term; the last
/// one, of the hourglass modes, for parallelepipeds). Source: Flanagan and Belytschko (1981), Int. J. Numer.
/// Meth. Eng. 17, 679-706, and (1984), J. Appl. Mech. 51, 35-40.
template <class Law>
HexStep advance_hex8(const Law& law, const HexParameters& parameters, const HexMotion& motion,
                     HexState<Law>& state);

extern template HexStep advance_hex8(const ElasticLaw&, const HexParameters&, const HexMotion&,
                                     HexState<ElasticLaw>&);
extern template HexStep advance_hex8(const PlasticLaw<LinearHardening>&, const HexParameters&,
                                     const HexMotion&, HexState<PlasticLaw<LinearHardening>>&);
extern template HexStep advance_hex8(const PlasticLaw<PowerHardening>&, const HexParameters&,
                                     const HexMotion&, HexState<PlasticLaw<PowerHardening>>&);
extern template HexStep advance_hex8(const PlasticLaw<JohnsonCookHardening>&, const HexParameters&,
                                     const HexMotion&, HexState<PlasticLaw<JohnsonCookHardening>>&);

}  // namespace contactsim
