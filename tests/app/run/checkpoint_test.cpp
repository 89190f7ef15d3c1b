// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/checkpoint.hpp"

#include "core/base/errors.hpp"
#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// A run of two blocks without contact, outputs or deaths, at a step.
struct StoredRun : SampleRun {
  explicit StoredRun(std::int64_t step = 0, double time = 0.0) {
    state.step = step;
    state.time = time;
    state.dt = 1e-3;
  }
  Checkpoint checkpoint(std::optional<double> shifted_to = std::nullopt) {
    return {model, state, nullptr, nullptr, nullptr, outputs, shifted_to, marks};
  }
  SimulationDefinition definition;
  Region region;
  Diagnostics diagnostics;
  OutputPlan outputs{ConditionScope{definition, region, {}, mesh, diagnostics}, model, OutputSettings{}};
  std::vector<RunMark> marks;
};

SavedState saved_by(StoredRun& run) {
  StateArchive archive_of_run;
  archive(run.checkpoint(), archive_of_run);
  return copy_of(archive_of_run.take());
}

}  // namespace

TEST_CASE("a state that is stored comes back in a run of the same mesh and materials", "[app][restart]") {
  StoredRun before(7, 0.5), now;
  before.state.velocity(1, 2) = 3.5;
  const SavedState saved = saved_by(before);
  StateArchive restored(saved);
  CHECK(archive(now.checkpoint(), restored).empty());
  CHECK(now.state.step == 7);
  CHECK(now.state.time == 0.5);
  CHECK(now.state.velocity(1, 2) == 3.5);
}

TEST_CASE("a state may begin at another time than its own", "[app][restart]") {
  StoredRun before(7, 0.5), now;
  const SavedState saved = saved_by(before);
  StateArchive restored(saved);
  archive(now.checkpoint(-1.0), restored);
  CHECK(now.state.time == -1.0);
  CHECK(now.state.step == 7);
}

TEST_CASE("a state of other materials or blocks is refused by what differs", "[app][restart]") {
  StoredRun before(7, 0.5), now;
  const SavedState saved = saved_by(before);
  StateArchive restored(saved);
  now.model.blocks[0].material = "steel (elastic)";
  CHECK_THROWS_WITH(archive(now.checkpoint(), restored), Contains("materials"));
  StoredRun fewer;
  fewer.model.blocks.pop_back();
  StateArchive again(saved);
  CHECK_THROWS_WITH(archive(fewer.checkpoint(), again), Contains("blocks"));
  CHECK(now.state.step == 0);
}
