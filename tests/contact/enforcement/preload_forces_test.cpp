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
  sums.add_node(0, Vector3d(0.0, 0.0, force), Vector3d(0.5 * force, 0.0, 0.0));
  sums.add_node(2, Vector3d(0.0, 0.0, -force), Vector3d::Zero());
  return sums;
}

}  // namespace

TEST_CASE("what contact pressed with before and does not now is let go evenly", "[contact][preload_forces]") {
  PreloadForces preload;
  preload.begin(pressed_by(10.0, true), pressed_by(6.0, true), 1.0, 3.0);
  CHECK(preload.share_of_before() == Approx(0.4));
  CHECK(preload.entries().size() == 2);
  for (const auto& [time, held] : {std::pair(1.0, 4.0), std::pair(2.0, 2.0), std::pair(3.0, 0.0)}) {
    ContactAssembler sums(3, 1, false, true);
    sums.begin_step();
    preload.add_to(sums, time);
    CHECK(sums.nodes()[0][2] == held);
    CHECK(sums.nodes()[2][2] == -held);
    CHECK(sums.moments()[0].x() == 0.5 * held);
  }
  CHECK(preload.entries().empty());
}

TEST_CASE("held preload goes on from a stored state", "[contact][preload_forces]") {
  PreloadForces preload, resumed;
  preload.begin(pressed_by(10.0), pressed_by(0.0), 0.0, 4.0);
  StateArchive saves;
  preload.archive(saves);
  const SavedState memory = saves.take();
  StateArchive restores(memory);
  resumed.archive(restores);
  ContactAssembler sums(3, 1, false);
  sums.begin_step();
  resumed.add_to(sums, 1.0);
  CHECK(sums.nodes()[0][2] == 7.5);
}
