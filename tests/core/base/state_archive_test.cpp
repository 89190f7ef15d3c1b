// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/state_archive.hpp"

#include <cmath>
#include <limits>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;

namespace {

struct Spring {
  std::array<std::uint32_t, 2> nodes{};
  Eigen::Vector3f force = Eigen::Vector3f::Zero();
  double energy = 0.0;
  bool is_cut = false;
};

void visit(Spring& spring, RowNumbers& row) { row(spring.nodes, spring.force, spring.energy, spring.is_cut); }

/// Something of every kind that a run remembers.
struct Memory {
  std::vector<Spring> springs;
  std::vector<std::uint8_t> flags;
  std::vector<Eigen::Vector3d> slips;
  std::set<std::uint64_t> pairs;
  std::optional<std::int64_t> last;
  double time = 0.0;
  Eigen::Matrix3Xd velocity = Eigen::Matrix3Xd::Zero(3, 2);

  void archive(StateArchive& saved) {
    saved.expect("mesh", 42, "a mesh");
    saved.rows("springs", springs, visit);
    saved.list("flags", flags);
    saved.list("slips", slips);
    saved.set("pairs", pairs);
    saved.optional("last", last);
    saved.numbers("time", time);
    saved.fixed("velocity", velocity);
  }
};

Memory sample() {
  Memory memory;
  memory.springs = {{{1, 0xffffffffu}, {0.1f, 0.2f, -0.0f}, std::nan(""), true},
                    {{3, 4}, {}, 1.0 / 3.0, false}};
  memory.flags = {1, 0, 255};
  memory.slips = {Eigen::Vector3d(1e-300, -2.0, std::numeric_limits<double>::infinity())};
  memory.pairs = {7, std::uint64_t{1} << 63};
  memory.last = -5;
  memory.time = 0.1;
  memory.velocity << 1, 2, 3, 4, 5, 6;
  return memory;
}

SavedState saved_of(Memory& memory) {
  StateArchive saved;
  memory.archive(saved);
  return saved.take();
}

std::string error_of(Memory& memory, const SavedState& state) {
  StateArchive saved(state);
  try {
    memory.archive(saved);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("what was saved comes back to the last bit", "[core][restart]") {
  Memory memory = sample(), restored;
  const SavedState state = saved_of(memory);
  REQUIRE(error_of(restored, state) == "");
  REQUIRE(restored.springs.size() == 2);
  CHECK(restored.springs[0].nodes == memory.springs[0].nodes);
  CHECK(restored.springs[0].force == memory.springs[0].force);
  CHECK(std::signbit(restored.springs[0].force[2]));
  CHECK(std::isnan(restored.springs[0].energy));
  CHECK(restored.springs[0].is_cut);
  CHECK(restored.springs[1].energy == 1.0 / 3.0);
  CHECK(restored.flags == memory.flags);
  CHECK(restored.slips == memory.slips);
  CHECK(restored.pairs == memory.pairs);
  CHECK(restored.last == -5);
  CHECK(restored.time == 0.1);
  CHECK(restored.velocity == memory.velocity);
}

TEST_CASE("a state of another size or without an array is refused with the name of the array",
          "[core][restart]") {
  Memory memory = sample();
  const SavedState state = saved_of(memory);
  Memory larger;
  larger.velocity = Eigen::Matrix3Xd::Zero(3, 3);
  CHECK_THAT(error_of(larger, state), Contains("velocity has 6 numbers, 9 are needed"));
  const SavedState empty("old.rsout.1");
  CHECK_THAT(error_of(larger, empty), Contains("old.rsout.1"));
}

TEST_CASE("a number that must be the same tells what differs", "[core][restart]") {
  StateArchive saved;
  saved.expect("mesh", 41, "a mesh");
  const SavedState state = saved.take();
  Memory memory;
  CHECK_THAT(error_of(memory, state), Contains("is of a run with other a mesh"));
}

TEST_CASE("the state of a run is restored into that of its start", "[core][restart]") {
  contactsim::test::SampleRun run, other;
  run.deform(Eigen::Vector3d(1.1, 0.9, 1.0).asDiagonal(), Eigen::Matrix3d::Identity());
  run.set_point_value(1, 1, 2, 5e6);
  run.state.step = 17;
  run.state.time = 0.3;
  run.state.energies.internal = 2.5;
  run.state.rigid.resize(1);
  run.state.rigid[0].orientation = Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5);
  StateArchive saved;
  archive(run.state, saved);
  const SavedState state = saved.take();
  StateArchive restored(state);
  archive(other.state, restored);
  CHECK(other.state.step == 17);
  CHECK(other.state.time == 0.3);
  CHECK(other.state.coordinates == run.state.coordinates);
  CHECK(other.state.velocity == run.state.velocity);
  CHECK(other.state.energies.internal == 2.5);
  REQUIRE(other.state.rigid.size() == 1);
  CHECK(other.state.rigid[0].orientation.coeffs() == run.state.rigid[0].orientation.coeffs());
  for (std::size_t b = 0; b < 2; ++b) {
    for (std::size_t i = 0; i < run.state.blocks[b].values.size(); ++i)
      CHECK((other.state.blocks[b].values[i] == run.state.blocks[b].values[i]).all());
  }
}
