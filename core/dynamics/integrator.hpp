// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/dynamics/time_step.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

class RankShare;
class Subcycler;

/// What pushes the nodes of a run.
struct ForceTerms {
  ForceTerm& internal;
  ForceTerm& external;
  ForceTerm* contact = nullptr;
  Subcycler* subcycler = nullptr;  ///< of the elements that are advanced in parts of a step
  RankShare* share = nullptr;      ///< of load steps on several ranks, that of the internal term
};

/// What a step was like, besides the state it left.
struct StepReport {
  double stable_step = 0.0;  ///< the largest that all force terms allow, not scaled [time]
  std::optional<ElementIndex> critical_element;  ///< absent where contact or nothing sets it
};

/// Completes a state whose coordinates, velocities and stresses are those of the start: forces,
/// accelerations, the first step. Throws SolveError.
///   share  of a rank, as InternalForce has it; null: of a process by itself
StepReport start(const Model& model, ForceTerms forces, const TimeStepControl& control, State& state,
                 RankShare* share = nullptr);

/// Brings a state to the end of its next step by central differences:
///   v(t + dt/2) = v(t) + dt/2 a(t);  x(t + dt) = x(t) + dt v(t + dt/2);  a(t + dt) = forces / mass, then
///   constrained;  v(t + dt) = v(t + dt/2) + dt/2 a(t + dt).
/// Sums over nodes are made in a fixed order: the same bits for any number of threads. Throws SolveError when
/// a step vanishes or a number is not finite; the state is then that of the failed step.
/// Source: Belytschko, Liu, Moran & Elkhodary, Nonlinear Finite Elements (2014), box 6.1 and eq. 6.2.14-17.
/// A rank brings the nodes that it follows to there.
StepReport advance(const Model& model, ForceTerms forces, const TimeStepControl& control, State& state,
                   RankShare* share = nullptr);

}  // namespace contactsim
