// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "app/run/run_death.hpp"
#include "app/run/run_marks.hpp"
#include "core/base/state_archive.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/output/output_plan.hpp"
#include "core/statics/load_steps.hpp"

namespace contactsim {

/// All of a run that changes from step to step and that the next step builds on.
struct Checkpoint {
  const Model& model;
  State& state;
  RunContact* contact;    ///< null without contact
  LoadSteps* load_steps;  ///< null in explicit procedures
  RunDeath* death;        ///< null when nothing can die
  OutputPlan& outputs;
  std::optional<double> shifted_to;   ///< the time that a restored state begins at, if not its own [time]
  const std::vector<RunMark>& marks;  ///< of now
};

/// Saves it, or restores it in a run of the same mesh, materials and contact. Returns the marks that are not
/// as they were. Throws FileError when the saved one is of another run.
std::vector<RunMark> archive(const Checkpoint& checkpoint, StateArchive& saved);

}  // namespace contactsim
