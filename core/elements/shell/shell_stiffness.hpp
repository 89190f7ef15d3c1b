// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "core/elements/shell/shell_kernel.hpp"
#include "core/materials/material_law.hpp"

/// How stiff shells are, for their stable step and their resistance to hourglass modes.
namespace contactsim::shells {

/// Moduli that bound a shell's stiffness: a rate D of strain in the surface meets a power of the stress rate
/// of at most lambda (tr D)^2 + 2 shear D : D, and angles across the thickness one of `across` times their
/// squares.
struct ShellModuli {
  double lambda, shear, across, youngs, bulk;

  explicit ShellModuli(const MaterialLaw& law) {
    const ElasticModuli moduli = law.moduli();
    const PlaneModuli plane(moduli);
    lambda = std::max(plane.across, 0.0);
    shear = moduli.shear;
    across = moduli.shear;
    bulk = moduli.bulk;
    youngs = 9.0 * moduli.bulk * moduli.shear / (3.0 * moduli.bulk + moduli.shear);
  }
};

/// The stiffness of a kind of hourglass modes, times their scale.
inline Lanes mode_stiffness(HourglassKind kind, const ShellSettings& settings, const ShellModuli& moduli,
                            const ShellSizes& sizes, const Lanes& thickness) {
  const Lanes volume = sizes.area * thickness;
  switch (kind) {
    case HourglassKind::membrane:
      return settings.membrane_hourglass * 0.5 * moduli.youngs * volume * sizes.gram_trace();
    case HourglassKind::bending:
      return settings.bending_hourglass / 48.0 * moduli.youngs * volume * thickness * thickness *
             sizes.gram_trace();
    case HourglassKind::shear:
      break;
  }
  return settings.shear_hourglass * shear_correction / 48.0 * moduli.across * volume;
}

/// A bound for the squared frequency of the strains. With amplitudes V and W of motion in the surface and
/// along the normal, and T of turning, the layers give at most [[a, b], [b, d]] in V and T, the shear a rank
/// of size p + q in W and T: the largest eigenvalue of [[a, b], [b, d + p + q]] bounds them all.
template <std::size_t n>
Lanes strain_frequency(const ShellMotion<n>& motion, const ShellSettings& settings, const ShellModuli& moduli,
                       const ShellSizes& sizes) {
  double first = 0.0, second = 0.0;  // moments of the layers about the nodes
  for (const ShellLayer& layer : settings.layers) {
    const double height = 0.5 * layer.place + settings.offset;
    first += layer.weight * height;
    second += layer.weight * height * height;
  }
  const Lanes& t = motion.thickness;
  const Lanes warp = sizes.warp * t;  // moments by powers of the thickness
  const Lanes largest = sizes.gram_eigenvalue();
  const Lanes in_plane = sizes.area * t * (moduli.lambda * sizes.gram_trace() + 2.0 * moduli.shear * largest);
  const Lanes across = shear_correction * moduli.across * sizes.area * t;
  const Lanes per_mass = static_cast<double>(n) / motion.mass;
  const Lanes per_inertia = static_cast<double>(n) / motion.inertia;
  const Lanes tilted = 1.0 + sizes.tilt;
  const Lanes a = in_plane * per_mass * (1.0 + 2.0 * std::abs(first) * warp + second * warp * warp);
  const Lanes b = in_plane * t * (std::abs(first) + second * warp) * (tilted * per_mass * per_inertia).sqrt();
  const Lanes d = in_plane * t * t * second * tilted * per_inertia;
  const Lanes shear = across * (largest * per_mass + sizes.shear_by_turning * per_inertia);
  const Lanes half = 0.5 * (a - d - shear);
  return 0.5 * (a + d + shear) + (half * half + b * b).sqrt();
}

}  // namespace contactsim::shells
