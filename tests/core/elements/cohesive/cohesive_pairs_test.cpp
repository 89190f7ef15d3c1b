// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/cohesive/cohesive_pairs.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Stiffness 10 / (0.1 x 2) = 50 against opening, 10 x 2 / (0.1 x 16) = 12.5 against sliding; peak from 0.1
/// to 0.5 of 2 (opening) or 4 (sliding).
constexpr TractionLaw pair_law{10.0, 0.1, 0.5, 2.0, 4.0, 3.0};

/// One pair in every lane.
struct Pair {
  std::array<Lanes, cohesive::n_numbers> numbers;

  Pair() { numbers.fill(Lanes::Zero()); }
  /// Moves it; returns the work per area.
  double move(double open, double slide, bool is_gone = false) {
    cohesive::stretch(pair_law, Lanes::Constant(open), Lanes::Constant(slide), numbers);
    return cohesive::pull(pair_law, LaneMask(is_gone), numbers)(3);
  }
  double at(cohesive::Number number) const { return numbers[number](3); }
  double damage() const { return cohesive::damage(pair_law, numbers)(3); }
};

}  // namespace

TEST_CASE("tractions rise to the peak, stay and fall to nothing", "[core][cohesive]") {
  Pair pair;
  CHECK(pair.damage() == 0.0);
  pair.move(0.1, 0.0);  // lambda 0.05
  CHECK(pair.at(cohesive::normal) == Approx(5.0));
  CHECK(pair.damage() == 0.0);
  pair.move(0.2, 0.0);
  CHECK(pair.at(cohesive::normal) == Approx(10.0));
  pair.move(0.8, 0.0);
  CHECK(pair.at(cohesive::normal) == Approx(10.0));
  CHECK(pair.damage() == Approx(0.75));  // 12.5 left of 50
  pair.move(1.0, 0.0);
  CHECK(pair.at(cohesive::normal) == Approx(10.0));
  pair.move(1.5, 0.0);  // half way down from 0.5 to 1
  CHECK(pair.at(cohesive::normal) == Approx(5.0));
  pair.move(2.0, 0.0);
  CHECK(pair.at(cohesive::normal) == 0.0);
  CHECK(pair.damage() == 1.0);
  pair.move(9.0, 9.0);
  CHECK(pair.at(cohesive::normal) == 0.0);
  CHECK(pair.at(cohesive::tangential) == 0.0);
}

TEST_CASE("sliding weakens opening, and back and again it goes along a line", "[core][cohesive]") {
  Pair pair;
  pair.move(0.0, 1.6);  // lambda 0.4: the slope has a quarter left
  CHECK(pair.at(cohesive::tangential) == Approx(0.25 * 12.5 * 1.6));
  CHECK(pair.at(cohesive::normal) == 0.0);
  pair.move(0.0, -0.4);
  CHECK(pair.at(cohesive::tangential) == Approx(-0.25 * 12.5 * 0.4));
  CHECK(pair.at(cohesive::largest) == Approx(0.4));
  pair.move(0.1, 0.0);
  CHECK(pair.at(cohesive::normal) == Approx(0.25 * 50.0 * 0.1));
  pair.move(0.6, 1.6);  // 0.3 and 0.4 make 0.5
  CHECK(pair.at(cohesive::largest) == Approx(0.5));
  CHECK(pair.at(cohesive::normal) == Approx(0.2 * 50.0 * 0.6));
  CHECK(cohesive::tangential_slope(pair_law, pair.numbers)(0) == Approx(0.2 * 12.5));
}

TEST_CASE("compression has its own stiffness, damaged or not, until all has failed", "[core][cohesive]") {
  Pair pair;
  pair.move(-0.1, 0.0);
  CHECK(pair.at(cohesive::normal) == Approx(-3.0 * 50.0 * 0.1));
  CHECK(pair.at(cohesive::largest) == 0.0);  // it does no damage
  pair.move(3.0, 0.0);
  pair.move(-0.1, 0.0);
  CHECK(pair.at(cohesive::normal) == Approx(-15.0));
  pair.move(-0.1, 0.0, true);
  CHECK(pair.at(cohesive::normal) == 0.0);
}

TEST_CASE("work is that of the mean tractions, and comes to the toughness", "[core][cohesive]") {
  Pair first;
  CHECK(first.move(0.1, 0.0) == Approx(0.5 * 5.0 * 0.1));
  CHECK(first.move(0.1, 0.2) == Approx(0.5 * 12.5 * 0.2 * 0.2));
  CHECK(first.move(0.0, 0.0) == Approx(-0.5 * 5.0 * 0.1 - 0.5 * 12.5 * 0.2 * 0.2));  // all comes back
  for (const double mix : {0.0, 0.3, 1.0}) {
    Pair pair;
    double work = 0.0;
    constexpr int n = 2000;
    for (int i = 1; i <= n; ++i) work += pair.move((1.0 - mix) * 3.0 * i / n, mix * 6.0 * i / n);
    CHECK(pair.damage() == 1.0);
    CHECK(work == Approx(pair_law.toughness()).epsilon(1e-5));  // 0.5 x 10 x 2 x 1.4
  }
}
