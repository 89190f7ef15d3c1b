// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/definition/solver.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/statics/equilibrium.hpp"
#include "core/statics/fading_forces.hpp"
#include "core/statics/static_springs.hpp"
#include "core/statics/static_unknowns.hpp"
#include "core/statics/step_forces.hpp"
#include "core/statics/step_start.hpp"

namespace contactsim {

class RankShare;
class Ranks;
class StateArchive;

/// Thrown where the search for an equilibrium is given up on request.
struct SearchGivenUp {};

/// The forces of a model at the end of a load step, whose increment is sought: every evaluation begins with
/// what elements remember of the step's start, so that trials leave no trace. Inertia has no part in it.
class StaticProblem final : public Equilibrium {
 public:
  /// All must outlive it; contact: that of the terms, null without.
  StaticProblem(const Model& model, ForceTerms terms, StaticContact* contact, ResidualReference reference,
                State& state);

  Ranks& ranks() const;      ///< that evaluate the problem together
  void complete_elements();  ///< all ranks know what all remember in the last evaluation
  /// Has evaluations throw SearchGivenUp once that is wanted; null: never.
  void give_up_when(std::function<bool()> wants_end) { wants_end_ = std::move(wants_end); }

  const StaticUnknowns& unknowns() const { return unknowns_; }
  Eigen::Index size() const { return unknowns_.size(); }

  /// To be called once the forces of the start are known: what was taken over may come back to rest without
  /// loads.
  void begin();
  /// To be called after it where a state is taken over: what is out of balance in it, such as what inertia
  /// bore, goes on to be held, less and less until a time.
  void let_go_until(double time);
  /// To be called once elements have died between two steps: forces become those of the living, and what is
  /// out of balance by that is let go in the step that follows.
  ///   lifeless  nodes of dead elements alone, of now: they stay where they are, as if held, ascending
  void note_deaths(std::vector<NodeIndex> lifeless);
  bool has_deaths() const { return has_deaths_; }  ///< whether it was called since the last step
  /// To be called once the state is that of before note_deaths() again.
  ///   lifeless    of then
  ///   has_deaths  what has_deaths() was then
  void undo_deaths(std::vector<NodeIndex> lifeless, bool has_deaths);
  /// Takes notice of lifeless nodes alone, where the state is one that note_deaths() has left.
  void hold_lifeless(std::vector<NodeIndex> lifeless) { held_.set_lifeless(std::move(lifeless)); }
  /// Begins a step at the state: fixed and prescribed directions and what is remembered are those of now.
  ///   dt  of the step [time]
  /// Throws SolveError when a condition has no finite value.
  void begin_step(double dt);
  /// Where nodes are at an increment of the step, those of bodies at their centres [3 x n_nodes].
  Eigen::Matrix3Xd coordinates_at(const Eigen::VectorXd& increment) const;
  const StaticBodies& bodies() const { return bodies_; }
  /// What goes on steadily for as long as the last step's motion does.
  Eigen::VectorXd steady_motion(double duration) const;
  /// What prescribed directions move by in the step, 0 of the others.
  const Eigen::VectorXd& prescribed() const { return prescribed_; }
  /// Takes the state of the last evaluation as that of the step's end, with the work that was done on the way
  /// by the mean of the forces at both ends.
  ///   increment  of the last evaluation
  void accept(const Eigen::VectorXd& increment);
  /// Brings back the state that the step began at.
  void restore();
  void archive(StateArchive& saved);
  /// The springs of contact of the last find_springs(), without what moves along held directions.
  const std::vector<ContactSpring>& springs() const { return springs_.all(); }
  StaticContact* contact() const { return contact_; }
  /// Has no trial of a search move a node by more than a length.
  void limit_motion(double longest) { longest_motion_ = longest; }
  /// Takes notice of the largest stiffness of a node, by which round-off is known [force/length].
  void set_stiffness(double largest) { stiffness_ = largest; }
  /// As evaluate(), but with forces on the nodes of rigid bodies, which those of bodies are sums of.
  bool evaluate_nodes(const Eigen::VectorXd& increment, Eigen::VectorXd& forces);

  bool evaluate(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) override;
  double norm(const Eigen::VectorXd& residual) const override { return unknowns_.norm(residual); }
  double reference() const override;
  double round_off() const override;
  Eigen::VectorXd scales(Eigen::Index /*size*/) const override { return unknowns_.weights().cwiseSqrt(); }
  double probe_factor(const Eigen::VectorXd& direction) const override;
  bool is_rough() const override { return contact_ != nullptr; }
  void hold_rough(bool does) override { holds_contact_ = does; }
  bool hold_slip_limits(bool does) override {
    return contact_ != nullptr && contact_->hold_slip_limits(does);
  }
  void find_springs() override { springs_.find(contact_, bodies_, held_); }
  void add_springs(const Eigen::VectorXd& direction, Eigen::VectorXd& product) const override;
  double longest_step(const Eigen::VectorXd& direction) const override;
  void project(Eigen::VectorXd& vector) const override { held_.project(vector); }

  /// By how much an unknown may move for a derivative by differences [length], of rotations [1].
  double probe_of(Eigen::Index unknown) const {
    return unknown < unknowns_.n() ? probe_length_ : probe_angle;
  }
  /// Fixed and prescribed directions of the step.
  const HeldDirections& held() const { return held_; }

 private:
  static constexpr double probe_angle = 1e-6;

  double reference_now() const;
  Eigen::VectorXd unbalanced_at_start() const;
  void move_to(const Eigen::VectorXd& increment);
  void set_forces(const Motion& motion);
  void set_forces_of_mesh(const Motion& motion);
  StepForces forces() const { return {unknowns_, bodies_, state_, start_}; }
  Eigen::VectorXd moved(const Eigen::VectorXd& increment) const;

  std::function<bool()> wants_end_;
  const Model& model_;
  ForceTerms terms_;
  StaticContact* contact_;
  StaticSprings springs_;
  ResidualReference kind_;
  State& state_;
  StaticBodies bodies_;
  StaticUnknowns unknowns_;
  double probe_length_;
  bool holds_contact_ = false;
  double stiffness_ = 0.0;  // largest of a node [force/length]
  double increment_ = 0.0;  // largest of a node in the last evaluation [length]
  double longest_motion_ = std::numeric_limits<double>::infinity();  // [length]
  double dt_ = 0.0;
  bool has_deaths_ = false;         // since the last step
  Eigen::VectorXd let_go_;          // out of balance by deaths; empty: nothing
  double largest_reference_ = 0.0;  // of accepted steps
  FadingForces taken_over_;         // out of balance in what was taken over
  HeldDirections held_;
  Eigen::VectorXd prescribed_;
  StepStart start_;
};

}  // namespace contactsim
