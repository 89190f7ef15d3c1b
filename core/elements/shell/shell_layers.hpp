// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell/shell_kernel.hpp"

/// The layers of shells and their thickness in a step.
namespace contactsim::shells {

/// Sums of the layers' stresses, per area and by powers of the thickness; the work of the step on them, per
/// volume; the strain of the step along the normal.
struct Resultants {
  std::array<Lanes, 3> membrane, curvature;
  std::array<Lanes, 2> shear;
  Lanes work, thickening;
  Lanes stiffening = Lanes::Ones();  ///< of the layers' moduli at rest, the largest [1]

  static Resultants zero() {
    const Lanes none = Lanes::Zero();
    return {{none, none, none}, {none, none, none}, {none, none}, none, none, Lanes::Ones()};
  }
  /// Adds the stress of a layer of a weight at a share of the thickness from the nodes.
  void add(double weight, double share, const PlaneLanes& stress) {
    for (std::size_t i = 0; i < 3; ++i) {
      membrane[i] += weight * stress[i];
      curvature[i] += weight * share * stress[i];
    }
    shear[0] += shear_correction * weight * stress[4];
    shear[1] += shear_correction * weight * stress[3];
  }
};

/// The thickness of a layer over that at rest, of laws that know it; else 1.
///   material  [n_state]
inline Lanes thinning_of(const MaterialLaw& law, std::span<const Lanes> material) {
  return law.kind().plane_thinning != nullptr ? law.plane_thinning(material) : Lanes(Lanes::Ones());
}

/// What moves the layers.
template <std::size_t n_modes>
struct LayerStep {
  const ShellSettings& settings;
  const ShellRates<n_modes>& rates;  ///< in the middle of the step [1/time], [1/(length time)]
  const Lanes& thickness;            ///< [length]
  double dt;                         ///< [time]
  double bulk;                       ///< modulus of the material [force/length^2]

  /// How a layer at some height over the nodes deforms.
  PlaneStep at_height(const Lanes& height) const {
    PlaneStep step{{}, dt};
    for (std::size_t i = 0; i < 3; ++i)
      step.strain[i] = dt * (rates.membrane[i] + height * rates.curvature[i]);
    step.strain[3] = dt * rates.shear[1];
    step.strain[4] = dt * rates.shear[0];
    return step;
  }
};

/// Brings the layers to the end of the step. Along the normal they strain as their law says, or such that
/// their volume changes as the mean of their stress does: flow keeps it. Precondition: the law has
/// update_plane.
///   layers  [n_layers x (6 + n_state)] xx yy zz xy yz zx, then what the material remembers
template <std::size_t n>
Resultants update_layers(const MaterialLaw& law, const LayerStep<n>& layer_step, std::span<Lanes> layers) {
  const ShellSettings& settings = layer_step.settings;
  Resultants sums = Resultants::zero();
  const LawKind& kind = law.kind();
  const std::size_t point_size = 6 + kind.n_state;
  const double per_bulk = 1.0 / (3.0 * layer_step.bulk);
  for (std::size_t layer = 0; layer < settings.layers.size(); ++layer) {
    const ShellLayer& at = settings.layers[layer];
    const std::span<Lanes> point = layers.subspan(layer * point_size, point_size);
    const double share = 0.5 * at.place + settings.offset;
    const PlaneStep step = layer_step.at_height(layer_step.thickness * share);
    PlaneLanes before, stress;
    for (std::size_t i = 0; i < 5; ++i) stress[i] = before[i] = point[plane_places[i]];
    const std::span<Lanes> material = point.subspan(6);
    const Lanes thickness_before = thinning_of(law, material);
    law.update_plane(step, stress, material);
    Lanes work = Lanes::Zero();
    for (std::size_t i = 0; i < 5; ++i) {
      point[plane_places[i]] = stress[i];
      work += (i < 3 ? 0.5 : 0.5 * shear_correction) * step.strain[i] * (before[i] + stress[i]);
    }
    sums.add(at.weight, share, stress);
    if (kind.plane_thinning != nullptr) {
      const Lanes now = law.plane_thinning(material);
      sums.thickening += at.weight * 2.0 * (now - thickness_before) / (now + thickness_before);
    } else {
      for (std::size_t i = 0; i < 2; ++i)
        sums.thickening += at.weight * (per_bulk * (stress[i] - before[i]) - step.strain[i]);
    }
    if (kind.plane_stiffening != nullptr)
      sums.stiffening = sums.stiffening.max(law.plane_stiffening(material) / thinning_of(law, material));
    sums.work += at.weight * work;
  }
  return sums;
}

/// The thickness in a step.
struct ThicknessStep {
  Lanes middle, end;  ///< [length]

  ///   growth  of the thickness over that at the start of the run; brought to the end of the step [1]
  ThicknessStep(const Lanes& start, const Lanes& strain, Lanes& growth) {
    const Lanes factor = (1.0 + 0.5 * strain) / (1.0 - 0.5 * strain);
    growth = factor * (1.0 + growth) - 1.0;
    end = factor * start;
    middle = 0.5 * (start + end);
  }
};

}  // namespace contactsim::shells
