// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell_kernel.hpp"

/// The layers of shells in a step.
namespace contactsim::shells {

/// Sums of the layers' stresses, per area, and the work of the step on them.
struct Resultants {
  std::array<Lanes, 3> membrane, curvature;
  std::array<Lanes, 2> shear;
  Lanes work;
  Lanes stiffening = Lanes::Ones();  ///< largest of the layers, as Law::plane_stiffening
};

/// Makes a stress that of the thickness at rest.
///   material  [n_state]
template <class Law>
void thin(const Law& law, std::span<const Lanes> material, PlaneLanes& stress) {
  if constexpr (requires { law.plane_thinning(material); }) {
    const Lanes thinning = law.plane_thinning(material);
    for (Lanes& component : stress) component *= thinning;
  }
}

/// Brings the layers to the end of the step.
///   rates   in the middle of the step [1/time], [1/(length time)]
///   layers  [n_layers x (6 + n_state)] xx yy zz xy yz zx, then what the material remembers
template <class Law, std::size_t n>
Resultants update_layers(const Law& law, const ShellSettings& settings, const ShellRates<n>& rates,
                         const Lanes& thickness, double dt, std::span<Lanes> layers) {
  Resultants sums;
  for (Lanes& sum : sums.membrane) sum.setZero();
  for (Lanes& sum : sums.curvature) sum.setZero();
  for (Lanes& sum : sums.shear) sum.setZero();
  sums.work.setZero();
  constexpr std::size_t point_size = 6 + Law::n_state;
  for (std::size_t layer = 0; layer < settings.layers.size(); ++layer) {
    const ShellLayer& at = settings.layers[layer];
    const std::span<Lanes> point = layers.subspan(layer * point_size, point_size);
    const Lanes height = thickness * (0.5 * at.place + settings.offset), weight = at.weight * thickness;
    PlaneStep step{{}, dt};
    for (std::size_t i = 0; i < 3; ++i)
      step.strain[i] = dt * (rates.membrane[i] + height * rates.curvature[i]);
    step.strain[3] = dt * rates.shear[1];
    step.strain[4] = dt * rates.shear[0];
    PlaneLanes before, stress;
    for (std::size_t i = 0; i < 5; ++i) stress[i] = before[i] = point[plane_places[i]];
    const std::span<Lanes> material = point.subspan(6);
    thin(law, material, before);
    law.update_plane(step, stress, material);
    for (std::size_t i = 0; i < 5; ++i) point[plane_places[i]] = stress[i];
    thin(law, material, stress);
    if constexpr (requires { law.plane_stiffening(material); })
      sums.stiffening = sums.stiffening.max(law.plane_stiffening(material));
    Lanes work = Lanes::Zero();
    for (std::size_t i = 0; i < 5; ++i) {
      work += (i < 3 ? 0.5 : 0.5 * shear_correction) * step.strain[i] * (before[i] + stress[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      sums.membrane[i] += weight * stress[i];
      sums.curvature[i] += weight * height * stress[i];
    }
    sums.shear[0] += shear_correction * weight * stress[4];
    sums.shear[1] += shear_correction * weight * stress[3];
    sums.work += weight * work;
  }
  return sums;
}

}  // namespace contactsim::shells
