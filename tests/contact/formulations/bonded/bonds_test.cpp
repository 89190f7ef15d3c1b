// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/bonded/bonds.hpp"
#include "core/interface_laws/cohesive_zone.hpp"
#include "core/interface_laws/spring_weld.hpp"
#include "core/interface_laws/threaded.hpp"
#include "support/catch.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const LawCurve hump({{0, 0}, {0.5, 10}, {1, 0}}), line({{0, 0}, {0.1, 50}});

std::vector<BondLaw> bonds() {
  return {make_spring_bond(line, line, 2.0), make_threaded_bond({line, line, {}, 1.0, 1e9, 1e9, 2.0}),
          make_cohesive_bond({hump, 0.1, 0.2})};
}

}  // namespace

TEST_CASE("what bonds store and lose is the work done on them", "[contact][bonds]") {
  for (const BondLaw& hold : bonds()) {
    Random random(1);
    BondHistory history;
    double work = 0.0, lost = 0.0;
    Opening opening;
    BondAnswer last;
    Eigen::Vector3d target = Eigen::Vector3d::Zero(), at = target;
    for (int i = 0; i < 20000; ++i) {
      if (i % 1000 == 0) target = random_vector(random, 0.06).cwiseAbs();
      const Eigen::Vector3d next = at + 0.004 * (target - at);
      const Eigen::Vector3d move = next - at;
      at = next;
      opening = {at.z(), at.head<2>()};
      const BondAnswer now = answer(hold, opening, 2.0, 1e6, history);
      work += 0.5 * ((last.normal + now.normal) * move.z() +
                     (last.tangential + now.tangential).dot(move.head<2>()));
      CHECK(now.dissipated >= -1e-15);
      lost += now.dissipated;
      last = now;
    }
    CHECK(last.stored > 1e-3);
    CHECK(work == Approx(last.stored + lost).epsilon(1e-3));  // straight lines of 20000 steps
  }
}

TEST_CASE("no bond is stiffer than it says", "[contact][bonds]") {
  for (const BondLaw& hold : bonds()) {
    const double stiffest = bond_stiffness(hold, 2.0, 1e6);
    constexpr double step = 1e-7;
    for (double x = 0.001; x < 0.099; x += 0.0037) {
      for (const bool is_normal : {true, false}) {
        BondHistory first, second;
        const auto at = [&](double u) { return is_normal ? Opening{u, {0, 0}} : Opening{0.0, {u, 0.0}}; };
        const BondAnswer a = answer(hold, at(x), 2.0, 1e6, first),
                         b = answer(hold, at(x + step), 2.0, 1e6, second);
        const double slope = is_normal ? b.normal - a.normal : b.tangential.x() - a.tangential.x();
        CHECK(slope / step <= stiffest * 1.00001);
      }
    }
  }
}

TEST_CASE("a cohesive zone that begins rigidly begins with the penalty", "[contact][bonds]") {
  const BondLaw hold = make_cohesive_bond({LawCurve({{0, 10}, {1, 0}}), 0.1, 0.1});
  BondHistory history;
  CHECK(answer(hold, {0.001, {0, 0}}, 1.0, 1000.0, history).normal == Approx(1.0));
  CHECK(answer(hold, {0.05, {0, 0}}, 1.0, 1000.0, history).normal == Approx(5.0));
  CHECK(bond_stiffness(hold, 1.0, 1000.0) == Approx(1000.0));
}

TEST_CASE("bonds answer slip under pressure, but do not push", "[contact][bonds]") {
  for (const BondLaw& hold : bonds()) {
    BondHistory history;
    const BondAnswer pressed = answer(hold, {-0.01, {0.03, 0.0}}, 1.0, 1e6, history);
    CHECK(pressed.normal == 0.0);
    CHECK(pressed.tangential.x() > 0.0);
    CHECK(pressed.tangential.y() == 0.0);
  }
}
