// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/preload_forces.hpp"

#include "core/base/state_archive.hpp"

#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

ContactAssembler pressed_by(double force, bool has_moments = false) {
  ContactAssembler sums(3, 1, false, has_moments);
  sums.begin_step();
  sums.add_node({0}, Vector3d(0.0, 0.0, force), Vector3d(0.5 * force, 0.0, 0.0));
  sums.add_node({2}, Vector3d(0.0, 0.0, -force), Vector3d::Zero());
  return sums;
}

}  // namespace

TEST_CASE("what contact pressed with before and does not now is let go evenly", "[contact][preload_forces]") {
  PreloadForces preload;
  preload.take_over(pressed_by(10.0, true), 3.0);
  preload.begin(pressed_by(6.0, true), 1.0, false);
  CHECK(preload.share_of_before() == Approx(0.4));
  CHECK(preload.entries().size() == 2);
  for (const auto& [time, held] : {std::pair(1.0, 4.0), std::pair(2.0, 2.0), std::pair(3.0, 0.0)}) {
    ContactAssembler sums(3, 1, false, true);
    sums.begin_step();
    preload.add_to(sums, time);
    CHECK(sums.nodes()[{0}][2] == held);
    CHECK(sums.nodes()[{2}][2] == -held);
    CHECK(sums.moments()[{0}].x() == 0.5 * held);
  }
  CHECK(preload.entries().empty());
}

TEST_CASE("while contact finds its forces the nodes keep those of before", "[contact][preload_forces]") {
  // Contact presses with these besides what is held, step by step.
  const auto settled = [](const std::vector<double>& pressed) {
    PreloadForces preload;
    preload.take_over(pressed_by(10.0), 1e9);
    preload.begin(pressed_by(6.0), 0.0, true);
    std::vector<double> sums;
    for (const double own : pressed) {
      ContactAssembler step = pressed_by(own);
      preload.add_to(step, 0.0);
      if (preload.is_settling()) preload.settle(step);
      sums.push_back(step.nodes()[{0}][2]);
    }
    CHECK_FALSE(preload.is_settling());
    sums.push_back(preload.entries().at(0).force.z());
    CHECK(preload.share_of_before() == Approx(0.1 * sums.back()));
    return sums;
  };
  // It comes to rest at 4, after which its forces count.
  const std::vector<double> rest = settled({6.0, 5.0, 4.5, 4.25, 4.125, 4.0625, 4.0625, 3.0});
  for (std::size_t i = 0; i < 7; ++i) CHECK(rest[i] == Approx(10.0));
  CHECK(rest[7] == Approx(10.0 - 1.0625));
  CHECK(rest[8] == Approx(10.0 - 4.0625));
  // It goes ever farther away: what was held at first is held.
  const std::vector<double> away = settled({6.0, 5.0, 3.0, 2.0});
  CHECK(away[4] == Approx(4.0));
}

TEST_CASE("held preload goes on from a stored state", "[contact][preload_forces]") {
  PreloadForces preload, resumed;
  preload.take_over(pressed_by(10.0), 4.0);
  preload.begin(pressed_by(0.0), 0.0, false);
  StateArchive saves;
  preload.archive(saves);
  const SavedState memory = saves.take();
  StateArchive restores(memory);
  resumed.archive(restores);
  ContactAssembler sums(3, 1, false);
  sums.begin_step();
  resumed.add_to(sums, 1.0);
  CHECK(sums.nodes()[{0}][2] == 7.5);
}
