// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "core/base/lanes.hpp"
#include "core/materials/elastic_moduli.hpp"

/// Materials in thin shells: the stress along the normal is zero.
namespace contactsim {

/// Components along the axes of a shell, z along its normal: xx, yy, xy, yz, zx.
using PlaneLanes = std::array<Lanes, 5>;

/// Where PlaneLanes stand among xx, yy, zz, xy, yz, zx.
inline constexpr std::array<std::size_t, 5> plane_places{0, 1, 3, 4, 5};

/// How eight elements deform in a step at a place of their thickness. The axes turn with the material.
struct PlaneStep {
  PlaneLanes strain;  ///< increment; of shear, the angle: twice the tensor's component [1]
  double dt;          ///< size of the step; 0: the state at the start is asked for, nothing moves [time]
};

/// Stiffness of isotropic elasticity without stress along z.
struct PlaneModuli {
  double direct;  ///< xx by xx: E / (1 - nu^2) [force/length^2]
  double across;  ///< xx by yy: nu E / (1 - nu^2) [force/length^2]
  double shear;   ///< [force/length^2]

  explicit PlaneModuli(const ElasticModuli& moduli)
      : direct(4.0 * moduli.shear * (moduli.lambda() + moduli.shear) /
               (moduli.lambda() + 2.0 * moduli.shear)),
        across(2.0 * moduli.shear * moduli.lambda() / (moduli.lambda() + 2.0 * moduli.shear)),
        shear(moduli.shear) {}

  /// Adds what an elastic step does.
  void add(const PlaneLanes& strain, PlaneLanes& stress) const {
    stress[0] += direct * strain[0] + across * strain[1];
    stress[1] += across * strain[0] + direct * strain[1];
    for (std::size_t i = 2; i < 5; ++i) stress[i] += shear * strain[i];
  }
};

/// Components of a fibre that has no stress across it: xx along it, xy and zx.
using FibreLanes = std::array<Lanes, 3>;

/// Where FibreLanes stand among xx, yy, zz, xy, yz, zx.
inline constexpr std::array<std::size_t, 3> fibre_places{0, 3, 5};

/// How eight fibres deform in a step. Their axes turn with the material.
struct FibreStep {
  FibreLanes strain;  ///< increment; of shear, the angles [1]
  double dt;          ///< size of the step; 0: the state at the start is asked for, nothing moves [time]
};

}  // namespace contactsim
