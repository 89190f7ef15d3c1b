// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/statics/load_schedule.hpp"
#include "core/statics/newton.hpp"
#include "core/statics/nodal_blocks.hpp"
#include "core/statics/static_deaths.hpp"
#include "core/statics/tangent.hpp"

namespace contactsim {

/// What a load step came to.
struct LoadStepReport {
  CgReport search;
  double search_target = 0.0;      ///< of its forces left over, over their reference [1]
  std::int64_t n_evaluations = 0;  ///< of the residual, preconditioner and predictor included
  std::int64_t n_linear = 0;       ///< iterations of the equation solver, all trials of the step included
  std::int64_t n_cutbacks = 0;     ///< before it found equilibrium
  std::int64_t n_again = 0;  ///< times that equilibrium was sought anew after deaths, since the last cutback
  bool has_deaths_left = false;  ///< it was so as often as CONTROL FAILURE lets it: others may die at the end
  std::int64_t n_updates = 0;    ///< of the multipliers of contact, after each of which it was sought anew
  MultiplierChange contact;      ///< that the multipliers would still have changed by at the end
  std::optional<double> contact_target;  ///< of change over reference; absent where multipliers have no part
  std::optional<double> stabilizing_force;  ///< of contact that is stabilized, over the reference [1]
  bool ends_block = false;                  ///< of time stepping, where that is to be gone
  bool has_left_newton = false;             ///< its tangent led nowhere: nodal blocks found equilibrium
  std::int64_t n_negative = 0;  ///< directions of negative stiffness where the last factor was made

  /// Whether updates of multipliers ended at their largest number, below what is acceptable alone.
  bool is_contact_short() const {
    return contact_target && contact.change > *contact_target * contact.reference;
  }
};

/// A quasi-static run: from one equilibrium to the next, as time goes by and nothing moves by inertia. The
/// same bits for any number of threads, and of ranks, which work out forces together; between two steps, and
/// where deaths are looked for, each knows all of the state.
class LoadSteps {
 public:
  /// All must outlive it. Precondition: nothing in the model depends on velocities.
  ///   contact  the same as that of the terms, null without
  LoadSteps(const Model& model, ForceTerms terms, StaticContact* contact, const SolverSettings& settings,
            LoadSchedule schedule, State& state);
  LoadSteps(const LoadSteps&) = delete;
  LoadSteps& operator=(const LoadSteps&) = delete;

  /// Finds the forces of the start, and the first step. Throws SolveError.
  ///   takes_over  the state is one that another procedure came to: what is out of balance in it is let go
  ///               evenly over the first time stepping block
  void start(bool takes_over = false);
  /// Brings the state to the next equilibrium. Returns false when it was given up on request: the state is
  /// then the last equilibrium, and what comes next would be sought as if this had not been. Throws
  /// SolveError when none is found however small the step: the state is then the last equilibrium, too.
  bool advance();
  /// Has the search for an equilibrium be given up once that is wanted.
  ///   wants_end  asked before every evaluation of the forces
  void give_up_when(std::function<bool()> wants_end) { problem_.give_up_when(std::move(wants_end)); }

  /// To be called once elements have died in the state: the next equilibrium is that of the living, and nodes
  /// without any stay where they are.
  void note_deaths();
  /// Has elements die in the steps to come by CONTROL FAILURE, where the deck has it: a step is made anew
  /// without those that have died in it, until no others do. They live again where the step is cut back then.
  ///   deaths  must outlive it
  void follow_deaths(StaticDeaths& deaths) { deaths_ = &deaths; }

  const LoadStepReport& report() const { return report_; }
  /// The solver of the equations of Newton's steps; absent where the deck asks for nodal blocks alone.
  const std::optional<LinearSolverChoice>& linear_solver() const { return linear_solver_; }
  /// Of the last factor; absent without one.
  std::optional<FactorMemory> factor_memory() const;
  /// Saves or restores what the next step builds on besides the state.
  void archive(StateArchive& saved);

 private:
  void find_next();
  bool try_step(double dt);
  bool seek(double dt, Eigen::VectorXd& increment);
  bool has_deaths(std::int64_t n_rounds);
  void undo_deaths();
  std::vector<NodeIndex> find_lifeless();
  void find_free();
  void search(const CgSettings& cg, Eigen::VectorXd& increment);
  bool control_contact(const CgSettings& cg, Eigen::VectorXd& increment);
  void begin_stabilization(double dt);
  bool end_stabilization(double dt, const CgSettings& cg, Eigen::VectorXd& increment);
  Eigen::VectorXd first_guess(double dt) const;
  void renew_preconditioner(const Eigen::VectorXd& increment, bool may_keep_elements = false);
  bool has_tangent() const;
  [[noreturn]] void fail(std::string text) const;

  /// The start of a step in which elements have died since, as it was with them.
  struct BeforeDeaths {
    State state;
    bool has_deaths = false;  ///< StaticProblem::has_deaths()
  };

  const Model& model_;
  ForceTerms terms_;
  SolverSettings settings_;
  LoadSchedule schedule_;
  StaticDeaths* deaths_ = nullptr;
  State& state_;
  StaticProblem problem_;
  NodeGraph graph_;
  std::optional<NodeGraph> living_graph_;  // of the elements that live; absent: all do
  NodalBlocks blocks_;
  std::optional<LinearSolverChoice> linear_solver_;
  std::unique_ptr<Tangent> tangent_;  // null where the deck asks for none
  std::optional<LinearisedEquilibrium> linearised_;
  bool meets_negative_ = false;                // in the step
  Eigen::VectorXd residual_;                   // of the last evaluation
  double step_begun_ = 0.0;                    // [time]
  std::optional<BeforeDeaths> before_deaths_;  // absent: none has died in the step
  std::vector<std::uint32_t> free_;            // rigid bodies that conditions do not hold
  StabilizationLevel stabilization_;           // of the step as it is sought now
  LoadStepReport report_;
};

}  // namespace contactsim
