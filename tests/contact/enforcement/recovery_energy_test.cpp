// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/recovery_energy.hpp"

#include <cmath>

#include "contact/interface_laws/pair_rules.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;

TEST_CASE("momentum balance may give what impacts have lost and overlaps take",
          "[contact][recovery_energy]") {
  test::TwoCubes cubes;
  const std::size_t n_pairs = cubes.parts.rules.rules().size();
  RecoveryEnergy recovery(n_pairs);
  IndexedVector<PairIndex, PairHistory> histories(n_pairs);
  recovery.begin_step(cubes.parts.rules, histories);
  CHECK(recovery.available({0}) == 0.0);
  histories[{0}].impact = 3.0;
  histories[{0}].ramped = 0.5;
  CHECK(recovery.available({0}) == 0.0);  // of the steps before this one
  recovery.begin_step(cubes.parts.rules, histories);
  CHECK(recovery.available({0}) == 3.5);
  recovery.add_overlap({0}, 2.0);
  recovery.add_overlap({0}, 0.25);
  CHECK(recovery.available({0}) == 5.75);
  CHECK(recovery.of_overlaps({0}) == 2.25);
  histories[{0}].impact = -7.0;  // given already
  recovery.begin_step(cubes.parts.rules, histories);
  CHECK(recovery.available({0}) == 0.0);
  CHECK(recovery.of_overlaps({0}) == 2.25);
}

TEST_CASE("a pair begins in the step in which it becomes active, and each time anew",
          "[contact][recovery_energy]") {
  test::TwoCubes cubes;
  PairRules& rules = cubes.parts.rules;
  RecoveryEnergy recovery(rules.rules().size());
  const IndexedVector<PairIndex, PairHistory> histories(rules.rules().size());
  const auto begins = [&](double time, bool is_on) {
    rules.activate(time, is_on);
    recovery.begin_step(rules, histories);
    return recovery.has_begun({0});
  };
  CHECK_FALSE(begins(0.0, false));
  CHECK(begins(1.0, true));
  CHECK_FALSE(begins(2.0, true));
  CHECK_FALSE(begins(3.0, false));
  CHECK(begins(4.0, true));
}

TEST_CASE("while an overlap is ramped there is no limit", "[contact][recovery_energy]") {
  test::TwoCubes cubes("overlap ramp time = 2\n");
  PairRules& rules = cubes.parts.rules;
  rules.gap_offsets().set_start({}, 0.0);
  RecoveryEnergy recovery(rules.rules().size());
  const IndexedVector<PairIndex, PairHistory> histories(rules.rules().size());
  rules.activate(1.0, true);
  recovery.begin_step(rules, histories);
  CHECK(std::isinf(recovery.available({0})));
  rules.activate(2.5, true);
  recovery.begin_step(rules, histories);
  CHECK(std::isinf(recovery.available({0})));  // the step in which the ramp has ended
  rules.activate(3.0, true);
  recovery.begin_step(rules, histories);
  CHECK(recovery.available({0}) == 0.0);
}

TEST_CASE("a run that goes on knows which pairs were active and what overlaps took",
          "[contact][recovery_energy]") {
  test::TwoCubes cubes;
  const std::size_t n_pairs = cubes.parts.rules.rules().size();
  RecoveryEnergy recovery(n_pairs), other(n_pairs);
  IndexedVector<PairIndex, PairHistory> histories(n_pairs);
  recovery.begin_step(cubes.parts.rules, histories);
  recovery.add_overlap({0}, 2.0);
  StateArchive saves;
  recovery.archive(saves);
  const SavedState saved = saves.take();
  StateArchive restores(saved);
  other.archive(restores);
  histories[{0}].impact = 1.0;
  other.begin_step(cubes.parts.rules, histories);
  CHECK_FALSE(other.has_begun({0}));
  CHECK(other.available({0}) == 3.0);
}
