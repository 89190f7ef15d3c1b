// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/energy_watch.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

/// A unit cube of mass 8 whose coordinates are at most 1.
struct Cube {
  Mesh mesh = test::MeshBuilder().add_hexes({}).build();
  Model model;
  State state;
  EnergyWatch watch{model};

  Cube() {
    model.mesh = &mesh;
    model.mass = Eigen::RowVectorXd::Ones(8);
    state.dt = 1e-3;
  }

  /// Steps of a largest term and an error; returns the first that is off, -1 for none.
  template <class Term, class Error>
  int first_off(int n_steps, const Term& term, const Error& error) {
    for (int step = 1; step <= n_steps; ++step) {
      state.energies.largest = std::max(state.energies.largest, term(step));
      state.energies.error = error(step);
      if (watch.is_off(state)) return step;
    }
    return -1;
  }
};

}  // namespace

TEST_CASE("a run that begins at rest is not warned of the error of its first steps", "[app][energy]") {
  Cube cube;
  const auto fall = [](int step) { return 1e-10 * step * step; };  // of a constant force
  CHECK(cube.first_off(1000, fall, [](int) { return -4e-12; }) == -1);
  Cube loaded_late;
  const auto late = [&](int step) { return step < 500 ? 0.0 : fall(step - 499); };
  CHECK(loaded_late.first_off(1000, late, [](int step) { return step < 500 ? 0.0 : -4e-12; }) == -1);
}

TEST_CASE("a lasting error is reported when the energies have settled", "[app][energy]") {
  Cube cube;
  const auto fall = [](int step) { return 1e-10 * step * step; };
  const int step = cube.first_off(1000, fall, [&](int n) { return 0.02 * fall(n); });
  CHECK(step >= 20);
  CHECK(step <= 22);
  Cube moving;  // from the start
  CHECK(moving.first_off(
            1000, [](int) { return 5.0; }, [](int n) { return n > 7 ? 0.06 : 0.04; }) == 8);
}

TEST_CASE("energies that blow up are reported", "[app][energy]") {
  Cube cube;
  const auto grow = [](int step) { return std::pow(2.0, step); };
  const int step = cube.first_off(100, grow, [&](int n) { return 0.9 * grow(n); });
  CHECK(step > 0);
  CHECK(step < 40);
}

TEST_CASE("energies that are round-off alone are nobody's error", "[app][energy]") {
  Cube cube;
  const double round_off = energy_of_round_off(cube.model, 1e-3);
  CHECK(round_off == Approx(0.5 * 8 * 2.22e-13 * 2.22e-13).epsilon(0.01));
  CHECK(cube.first_off(
            100, [&](int) { return 0.5 * round_off; }, [&](int) { return 0.4 * round_off; }) == -1);
  CHECK(cube.first_off(
            100, [&](int) { return 10.0 * round_off; }, [&](int) { return round_off; }) > 0);
}
