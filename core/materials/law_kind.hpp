// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

#include "core/materials/elastic_moduli.hpp"
#include "core/materials/plane_step.hpp"
#include "core/materials/state_variable.hpp"
#include "core/materials/strain_step.hpp"

/// Stress updates of materials, eight elements at a time. A law is a class that states what it keeps per
/// element and point:
///   moduli       elastic, at rest
///   n_state      numbers in all
///   n_tensors    of them symmetric tensors, at the front, that turn with the material
///   variables    what of it can be written out
///   n_vectors    of laws with directions: unit vectors that turn with the material, after the tensors; of
///                shells and fibres in their axes, where they do not turn
///   failure      of laws that fail by themselves: the variable that reaches 1 then
///   adds_stress  of laws whose growth of the stress does not depend on the stress
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

/// What a law keeps and does, for those who do not know its class. Null or empty: it does not.
struct LawKind {
  std::size_t n_tensors = 0, n_state = 0, n_vectors = 0;
  std::span<const StateVariable> variables;
  std::string_view failure;
  bool adds_stress = false;
  void (*start)(const void* law, std::span<Lanes> state) = nullptr;
  LaneModuli (*update)(const void* law, const StrainStep& step, SymmetricLanes& stress,
                       std::span<Lanes> state) = nullptr;
  void (*update_plane)(const void* law, const PlaneStep& step, PlaneLanes& stress,
                       std::span<Lanes> state) = nullptr;
  void (*update_fibre)(const void* law, const FibreStep& step, FibreLanes& stress,
                       std::span<Lanes> state) = nullptr;
  using OfState = Lanes (*)(const void* law, std::span<const Lanes> state);
  OfState plane_thinning = nullptr, plane_stiffening = nullptr;
  OfState fibre_thinning = nullptr, fibre_stiffening = nullptr;

  template <class Law>
  static constexpr LawKind of();

 private:
  template <class Law>
  static const Law& held(const void* law) {
    return *static_cast<const Law*>(law);
  }
};

template <class Law>
constexpr LawKind LawKind::of() {
  LawKind kind;
  kind.n_tensors = Law::n_tensors;
  kind.n_state = Law::n_state;
  kind.variables = Law::variables;
  if constexpr (requires { Law::n_vectors; }) kind.n_vectors = Law::n_vectors;
  if constexpr (requires { Law::failure; }) kind.failure = Law::failure;
  if constexpr (requires { Law::adds_stress; }) kind.adds_stress = Law::adds_stress;
  kind.start = [](const void* law, std::span<Lanes> state) { held<Law>(law).start(state); };
  kind.update = [](const void* law, const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) {
    return held<Law>(law).update(step, stress, state);
  };
  if constexpr (requires { &Law::update_plane; })
    kind.update_plane = [](const void* law, const PlaneStep& step, PlaneLanes& stress,
                           std::span<Lanes> state) { held<Law>(law).update_plane(step, stress, state); };
  if constexpr (requires { &Law::update_fibre; })
    kind.update_fibre = [](const void* law, const FibreStep& step, FibreLanes& stress,
                           std::span<Lanes> state) { held<Law>(law).update_fibre(step, stress, state); };
  if constexpr (requires { &Law::plane_thinning; })
    kind.plane_thinning = [](const void* law, std::span<const Lanes> state) {
      return held<Law>(law).plane_thinning(state);
    };
  if constexpr (requires { &Law::plane_stiffening; })
    kind.plane_stiffening = [](const void* law, std::span<const Lanes> state) {
      return held<Law>(law).plane_stiffening(state);
    };
  if constexpr (requires { &Law::fibre_thinning; })
    kind.fibre_thinning = [](const void* law, std::span<const Lanes> state) {
      return held<Law>(law).fibre_thinning(state);
    };
  if constexpr (requires { &Law::fibre_stiffening; })
    kind.fibre_stiffening = [](const void* law, std::span<const Lanes> state) {
      return held<Law>(law).fibre_stiffening(state);
    };
  return kind;
}

/// The kind of a law, one object per class.
template <class Law>
inline constexpr LawKind law_kind = LawKind::of<Law>();

}  // namespace contactsim
