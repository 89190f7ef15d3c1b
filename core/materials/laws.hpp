// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/materials/elastic_moduli.hpp"
#include "core/materials/hardening.hpp"
#include "core/materials/plane_step.hpp"
#include "core/materials/state_variable.hpp"
#include "core/materials/strain_step.hpp"

/// Stress updates of materials, eight elements at a time. A law states what it keeps per element and point:
///   n_state    numbers in all
///   n_tensors  of them symmetric tensors, at the front, that turn with the material
///   variables  what of it can be written out
///   n_vectors  of laws with directions: unit vectors that turn with the material, after the tensors; of
///              shells and fibres in their axes, where they do not turn
///   failure    of laws that fail by themselves: the variable that reaches 1 then
/// and has
///   start      sets the state of undeformed material
///   update     brings stress and state to the end of a step; returns bounds of the stiffness then
///       stress  in: Cauchy stress at the start, turned to the end of the step; out: at the end
///       [force/length^2] state   [n_state], its tensors turned as well
/// and, when shells may be made of it,
///   update_plane  the same without stress along z, in axes that turn with the material
/// and, when beams and trusses may be,
///   update_fibre  the same with stress along x and shear on its cross-section alone
/// and, when the thickness or the cross-section changes or the stiffness exceeds that of the moduli,
///   plane_thinning(state), fibre_thinning(state)      thickness and area over those at rest [1]
///   plane_stiffening(state), fibre_stiffening(state)  the stiffness, per thickness and area at rest, is at
///                                                     most so many times that of the moduli [1]
namespace contactsim {

/// Hypoelastic: the stress rate is linear in the strain rate. Source: Sierra/SM, ELASTIC.
struct ElasticLaw {
  ElasticModuli moduli;
  static constexpr std::size_t n_tensors = 0, n_state = 0;
  static constexpr std::array<StateVariable, 0> variables{};

  void start(std::span<Lanes>) const {}
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
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
  static constexpr std::array variables = Hardening::variables;

  void start(std::span<Lanes> state) const {
    for (Lanes& number : state) number.setZero();
  }
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const;
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const;
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const;
};

extern template struct PlasticLaw<LinearHardening>;
extern template struct PlasticLaw<PowerHardening>;
extern template struct PlasticLaw<JohnsonCookHardening>;
extern template struct PlasticLaw<MultilinearHardening>;
extern template struct PlasticLaw<VoceHardening>;

}  // namespace contactsim
