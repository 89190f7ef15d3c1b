// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/lanes.hpp"
#include "core/materials/elastic_moduli.hpp"
#include "core/materials/hardening.hpp"

/// Stress updates of materials, eight elements at a time. A law states what it keeps per element:
///   n_tensors  symmetric tensors at the front of its state, which turn with the material
///   n_state    numbers in all, tensors included
namespace contactsim {

/// Hypoelastic: the stress rate is linear in the strain rate.
struct ElasticLaw {
  ElasticModuli moduli;
  static constexpr std::size_t n_tensors = 0, n_state = 0;

  /// Brings the stress to the end of a step.
  ///   strain    increment over the step, in the frame of `stress` [1]
  ///   dt        size of the step [time]
  ///   stress    in: Cauchy stress at the start, turned to the end; out: at the end [force/length^2]
  ///   state     [n_state]
  void update(const SymmetricLanes& strain, double dt, SymmetricLanes& stress, std::span<Lanes> state) const;
};

/// Von Mises plasticity with associated flow, brought back to the yield surface along its radius.
/// State: the back stress (if the hardening has one), then the equivalent plastic strain.
/// Source: Simo and Hughes, Computational Inelasticity (1998), 3.3; Wilkins, UCRL-7322 (1963).
template <class Hardening>
struct PlasticLaw {
  ElasticModuli moduli;
  Hardening hardening;
  static constexpr std::size_t n_tensors = Hardening::has_back_stress ? 1 : 0;
  static constexpr std::size_t n_state = 6 * n_tensors + 1;

  /// As ElasticLaw::update.
  void update(const SymmetricLanes& strain, double dt, SymmetricLanes& stress, std::span<Lanes> state) const;
};

extern template struct PlasticLaw<LinearHardening>;
extern template struct PlasticLaw<PowerHardening>;
extern template struct PlasticLaw<JohnsonCookHardening>;

}  // namespace contactsim
