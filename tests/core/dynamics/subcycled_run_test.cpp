// SPDX-License-Identifier: BSD-3-Clause
// Runs with subcycled elements: threads, ranks, restarts, shells.
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/graded_rod.hpp"
#include "support/lone_shell.hpp"
#include "support/subcycled_run.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a subcycled run has the same bits for any number of threads and ranks", "[core][subcycler]") {
  GradedRod rod({.n_large = 6000, .n_small = 3000, .bulk_viscosity = 0.06});
  rod.subcycle();
  const auto shake = [](State& state) {
    for (Eigen::Index i = 0; i < state.velocity.size(); ++i)
      state.velocity.data()[i] = 1e-3 * std::sin(1.7 * static_cast<double>(i * i % 1009));
  };
  const int n_threads = omp_get_max_threads();
  const auto run = [&](int threads, Ranks* ranks) {
    omp_set_num_threads(threads);
    SubcycledRun moved(rod.model, shake, 1e-6, ranks);
    moved.advance(5);
    omp_set_num_threads(n_threads);
    return moved.state;
  };
  const State one = run(1, nullptr);
  REQUIRE(one.subcycled.n_parts > 45);
  const auto check = [&](const State& other) {
    CHECK(other.coordinates == one.coordinates);
    CHECK(other.velocity == one.velocity);
    CHECK(other.acceleration == one.acceleration);
    CHECK(other.forces.internal == one.forces.internal);
    CHECK(other.energies.internal == one.energies.internal);
    CHECK(other.energies.error == one.energies.error);
    CHECK(other.next_dt == one.next_dt);
    for (std::size_t b = 0; b < 3; ++b) {
      CHECK(std::ranges::equal(other.blocks[b].values, one.blocks[b].values,
                               [](const Lanes& x, const Lanes& y) { return (x == y).all(); }));
      CHECK(other.blocks[b].hourglass_work == one.blocks[b].hourglass_work);
    }
  };
  check(run(3, nullptr));
  for (const int count : {2, 3}) {
    std::vector<State> states(static_cast<std::size_t>(count));
    ThreadRanks(count).run(
        [&](Ranks& ranks) { states[static_cast<std::size_t>(ranks.rank())] = run(1, &ranks); });
    for (const State& state : states) check(state);
  }
}

TEST_CASE("a subcycled run goes on from a restart as if it had not stopped", "[core][subcycler]") {
  GradedRod rod({});
  rod.subcycle();
  SubcycledRun whole(rod.model, strike), part(rod.model, strike), resumed(rod.model, [](State&) {});
  whole.advance(50);
  part.advance(23);
  StateArchive saves;
  archive(part.state, saves);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  archive(resumed.state, restores);
  resumed.advance(27);
  CHECK(resumed.state.coordinates == whole.state.coordinates);
  CHECK(resumed.state.velocity == whole.state.velocity);
  CHECK(resumed.state.acceleration == whole.state.acceleration);
  CHECK(resumed.state.energies.error == whole.state.energies.error);
  CHECK(resumed.state.subcycled.n_parts == whole.state.subcycled.n_parts);
  // Of a run with other classes nothing fits.
  GradedRod plain({});
  SubcycledRun other(plain.model, strike);
  StateArchive again(saved);
  CHECK_THROWS_AS(archive(other.state, again), FileError);
}

TEST_CASE("shells with small ones among them bend in parts of steps", "[core][subcycler]") {
  // A strip that turns and bends, with a row of narrow shells across it.
  const auto make_strip = [](bool subcycled, Mesh& mesh) {
    mesh =
        MeshBuilder()
            .add_shells({.id = 1, .cells = {20, 2}, .u = {20, 0, 0}, .v = {0, 2, 0}})
            .add_shells({.id = 2, .cells = {1, 2}, .origin = {20, 0, 0}, .u = {0.1, 0, 0}, .v = {0, 2, 0}})
            .add_shells({.id = 3, .cells = {20, 2}, .origin = {20.1, 0, 0}, .u = {20, 0, 0}, .v = {0, 2, 0}})
            .build();
    Model model;
    model.mesh = &mesh;
    const ElementProperties steel{ElasticLaw{{1.0, 0.5}}, 1.0};
    std::vector<double> steps;
    for (std::uint32_t b = 0; b < 3; ++b) {
      const std::vector<double> thickness(mesh.blocks()[b].n_elements, 0.2);
      model.blocks.push_back(make_shell_block(mesh, b, shell4_bt_shell, steel, gauss_layers(), thickness));
      steps.insert(steps.end(), mesh.blocks()[b].n_elements, b == 1 ? 0.1 : 1.0);
    }
    model.mass = lumped_mass(mesh, model.blocks);
    model.inertia = lumped_inertia(mesh, model.blocks);
    if (!subcycled) return model;
    const SubcycledSet set(model, steps, 1.0);
    model.subcycles = set.sums();
    for (std::size_t b = 0; b < 3; ++b) split_chunks(mesh, set.batches()[b], model.blocks[b]);
    return model;
  };
  const auto lift = [](State& state) {
    for (Eigen::Index i = 0; i < state.velocity.cols(); ++i)
      state.velocity(2, i) = 1e-3 * std::cos(state.coordinates(0, i) / 40.1 * 2.0 * M_PI);
  };
  Mesh mesh, same;
  const Model cycled = make_strip(true, mesh), plain = make_strip(false, same);
  SubcycledRun run(cycled, lift, 0.0, nullptr, std::nullopt),
      reference(plain, lift, 0.0, nullptr, std::nullopt);
  const double before = total(run.state);
  run.advance(150);
  while (reference.state.time < run.state.time) reference.advance(1);
  CHECK(reference.state.step > 5 * run.state.step);
  const Eigen::RowVectorXd u = reference.state.coordinates.row(2);
  const double largest = u.cwiseAbs().maxCoeff();
  CHECK(largest > 0.02);
  CHECK((run.state.coordinates.row(2) - u).cwiseAbs().maxCoeff() < 0.01 * largest);
  CHECK(total(run.state) == Approx(before).epsilon(0.01));
  CHECK(std::abs(run.state.energies.error) / before < 1e-8);  // steps differ by some 1e-6
}
