// SPDX-License-Identifier: BSD-3-Clause
#include "core/death/element_deaths.hpp"

#include <fmt/format.h>

#include <mutex>

#include "core/death/death_sets.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/johnson_cook.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/sample_run.hpp"
#include "support/thread_ranks.hpp"

// "soft", elements 101 to 109, is a row along x from 0 to 9; "hard", 110 and 111, stands on its first two.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The hard block is of a law that fails by itself.
struct FailingSample : SampleRun {
  FailingSample() {
    ModelBlock& hard = model.blocks[1];
    hard.properties.law = FailingJohnsonCookLaw{};
    hard.layout.point_size = 6 + FailingJohnsonCookLaw::n_state;
    state.blocks[1] = make_state(hard);
  }
};

/// A run whose elements may die by the lines of one ELEMENT DEATH block.
template <class Sample>
class DyingRunOf {
 public:
  explicit DyingRunOf(const std::string& lines)
      : deck(run.mesh, "begin element death d\n" + lines + "end\n"),
        sets(find_death_sets(deck.scope(), run.model)),
        variables(run.model),
        elements(run.mesh),
        faces(run.mesh, elements),
        deaths(deck.scope(), sets, variables, faces) {
    run.model.blocks[0].properties.law = ElasticLaw{{1.0, 0.5}};
    deaths.begin(run.state);
  }
  DyingRunOf(const DyingRunOf&) = delete;
  DyingRunOf& operator=(const DyingRunOf&) = delete;

  /// Ends a step; returns the ids of those who died.
  std::string step(double dt = 1.0, const std::vector<ElementIndex>& ill_defined = {}) {
    std::vector<std::int64_t> ids;
    for (const ElementIndex element : deaths.step(run.state, ill_defined))
      ids.push_back(run.mesh.element_id(element));
    ++run.state.step;
    run.state.time += dt;
    return fmt::format("{}", fmt::join(ids, " "));
  }
  double life(std::size_t element) const { return run.state.blocks[0].life_of(element); }

  Sample run;
  ConditionDeck deck;
  std::vector<std::vector<ElementIndex>> sets;
  OutputVariables variables;
  NodeElements elements;
  FaceGroups faces;
  ElementDeaths deaths;
};

using DyingRun = DyingRunOf<SampleRun>;

}  // namespace

TEST_CASE("nodal values kill by their mean, maximum or minimum over an element", "[core][death]") {
  // The nodes of element n stand at x = n - 101 and n - 100.
  DyingRun mean("block = soft\ncriterion is avg nodal value of coordinates(x) < 1.75\n");
  CHECK(mean.step() == "101 102");
  DyingRun most("block = soft\ncriterion is max nodal value of coordinates(x) >= 8\n");
  CHECK(most.step() == "108 109");
  DyingRun least("block = soft hard\ncriterion is min nodal value of coordinates(x) = 1\n");
  CHECK(least.step() == "102 111");
}

TEST_CASE("element values kill the elements that meet the test", "[core][death]") {
  DyingRun dying("include all blocks\ncriterion is element value of von_mises > 20\n");
  CHECK(dying.step() == "");
  dying.run.set_point_value(0, 3, 0, 21.0);  // xx alone is the equivalent stress
  dying.run.set_point_value(1, 1, 0, 20.0);
  CHECK(dying.step() == "104");
  CHECK(dying.step() == "");
  CHECK(dying.deaths.n_dead() == 1);
  CHECK(dying.deaths.alive()[3] == 0);
}

TEST_CASE("KILL WHEN counts the integration points that do not meet the test", "[core][death]") {
  DyingRun none(
      "block = soft\ncriterion is element value of von_mises > 20 kill when 0 integration points remain\n");
  none.run.set_point_value(0, 3, 0, 21.0);
  CHECK(none.step() == "104");
  DyingRun met_nowhere(
      "block = soft\ncriterion is element value of von_mises > 20 kill when 1 integration points remain\n");
  CHECK(met_nowhere.step() == "");
}

TEST_CASE("global values and ALWAYS TRUE kill the whole set", "[core][death]") {
  DyingRun timed("block = hard\ncriterion is global value of time >= 2\n");
  CHECK(timed.step() == "");
  CHECK(timed.step() == "");
  CHECK(timed.step() == "110 111");
  DyingRun listed("element = 103 107\ncriterion is always true\n");
  CHECK(listed.step() == "103 107");
}

TEST_CASE("criteria are looked at in the steps and at the times that the deck says", "[core][death]") {
  DyingRun by_steps("block = hard\ncriterion is global value of time >= 1\ncheck step interval = 3\n");
  CHECK(by_steps.step() + by_steps.step() + by_steps.step() == "");
  CHECK(by_steps.step() == "110 111");
  DyingRun by_time("block = hard\ncriterion is global value of time >= 1\ncheck time interval = 2.5\n");
  CHECK(by_time.step() + by_time.step() + by_time.step() == "");
  CHECK(by_time.step() == "110 111");
  DyingRun late("block = hard\ncriterion is always true\ndeath start time = 1.5\n");
  CHECK(late.step() + late.step() == "");
  CHECK(late.step() == "110 111");
}

TEST_CASE("a dying element fades over DEATH STEPS, whatever the criterion says meanwhile", "[core][death]") {
  DyingRun dying("element = 104\ncriterion is element value of von_mises > 20\ndeath steps = 3\n");
  dying.run.set_point_value(0, 3, 0, 30.0);
  const OutputContext context = dying.run.context();
  const auto stress = [&] { return stress_of(context, {0, 3, 1, {}}, 0)(0, 0); };
  CHECK(dying.step() == "");
  CHECK(dying.life(3) == Approx(2.0 / 3.0));
  CHECK(stress() == Approx(20.0));
  CHECK(dying.run.state.death.dying.size() == 1);
  CHECK(dying.step() == "");
  CHECK(dying.life(3) == Approx(1.0 / 3.0));
  CHECK(dying.step() == "104");
  CHECK(dying.life(3) == 0.0);
  CHECK(stress() == 0.0);
  CHECK(dying.run.state.death.dying.empty());
}

TEST_CASE("elements of ill defined contact die when the deck says so", "[core][death]") {
  DyingRun dying("block = soft\ndeath on ill defined contact = on\n");
  CHECK(dying.deaths.asks_for_ill_defined(dying.run.state));
  CHECK(dying.step(1.0, {{2}, {9}}) == "103");  // 110 is not of the set
}

TEST_CASE("a solid that has lost its last neighbour dies with it", "[core][death]") {
  DyingRun kept("element = 108\ncriterion is always true\n");
  CHECK(kept.step() == "108");
  DyingRun cleaned(
      "block = soft\ncriterion is min nodal value of coordinates(x) = 7\n"
      "aggressive contact cleanup = on\n");
  CHECK(cleaned.step() == "108 109");
  CHECK(cleaned.deaths.n_dead() == 2);
}

TEST_CASE("dead elements push nobody, the others as before to the last bit", "[core][death]") {
  DyingRun dying("element = 105\ncriterion is always true\n");
  SampleRun& run = dying.run;
  const Eigen::Matrix3d f = Eigen::Vector3d(1.01, 1.0, 1.0).asDiagonal();
  run.deform(f, 0.1 * Eigen::Matrix3d::Identity());
  const Motion motion{0.0, 0.01, run.state.coordinates, run.state.velocity};
  State other = run.state;
  Eigen::Matrix3Xd alive = Eigen::Matrix3Xd::Zero(3, run.mesh.n_nodes()), dead = alive;
  InternalForce(run.model, other).set_forces(motion, alive);
  CHECK(dying.step() == "105");
  const double before = run.state.blocks[0].at(run.model.blocks[0].layout, 4, 0);
  InternalForce term(run.model, run.state);
  const ForceReport report = term.set_forces(motion, dead);
  CHECK(run.state.blocks[0].at(run.model.blocks[0].layout, 4, 0) == before);
  CHECK(report.stable_step > 0.0);
  const auto of_105 = run.mesh.element_nodes({4});
  for (std::uint32_t node = 0; node < run.mesh.n_nodes(); ++node) {
    const bool is_near = std::find(of_105.begin(), of_105.end(), NodeIndex{node}) != of_105.end();
    INFO("node " << node);
    CHECK((alive.col(node) == dead.col(node)) == !is_near);
  }
  CHECK(dead.rowwise().sum().norm() < 1e-12);
}

TEST_CASE("an element that turns inside out dies in place of the run", "[core][death]") {
  DyingRun dying("block = soft\ndeath on inversion = on\n");
  SampleRun& run = dying.run;
  run.state.coordinates.col(run.mesh.element_nodes({8})[1].value).x() = 5.0;  // a far corner goes through
  const Motion motion{0.0, 0.0, run.state.coordinates, run.state.velocity};
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, run.mesh.n_nodes());
  for (const std::size_t corner : {2u, 5u, 6u})
    run.state.coordinates.col(run.mesh.element_nodes({8})[corner].value).x() = 5.0;
  InternalForce(run.model, run.state).set_forces(motion, forces);
  CHECK(forces.allFinite());
  CHECK(dying.life(8) == 0.0);
  CHECK(dying.step() == "109");
}

TEST_CASE("the step of a run whose elements are all dead is that of the mesh", "[core][death]") {
  DyingRun dying("include all blocks\ncriterion is always true\n");
  SampleRun& run = dying.run;
  const Motion motion{0.0, 0.0, run.state.coordinates, run.state.velocity};
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, run.mesh.n_nodes());
  const double alive = InternalForce(run.model, run.state).set_forces(motion, forces).stable_step;
  dying.step();
  CHECK(dying.deaths.n_dead() == 11);
  CHECK(InternalForce(run.model, run.state).set_forces(motion, forces).stable_step == alive);
  CHECK(forces.isZero(0.0));
}

TEST_CASE("a material criterion kills where the law has failed", "[core][death]") {
  DyingRunOf<FailingSample> dying("include all blocks\nmaterial criterion = on\n");
  CHECK(dying.deck.messages() == "");
  dying.run.set_point_value(1, 1, 7, 0.999);  // the damage of element 111
  CHECK(dying.step() == "");
  dying.run.set_point_value(1, 1, 7, 1.0);
  CHECK(dying.step() == "111");
}

TEST_CASE("of elements that fail by their material the worst may die alone", "[core][death]") {
  const auto step = [](DyingRunOf<FailingSample>& dying, DeathRound round) {
    std::vector<std::int64_t> ids;
    for (const ElementIndex element : dying.deaths.step(dying.run.state, {}, round))
      ids.push_back(dying.run.mesh.element_id(element));
    return fmt::format("{}", fmt::join(ids, " "));
  };
  const auto fail = [](DyingRunOf<FailingSample>& dying, double of_110, double of_111) {
    dying.run.set_point_value(1, 0, 7, of_110);
    dying.run.set_point_value(1, 1, 7, of_111);
  };
  DyingRunOf<FailingSample> dying("include all blocks\nmaterial criterion = on\n");
  fail(dying, 1.1, 1.2);
  CHECK(step(dying, {.takes_worst = true}) == "111");
  CHECK(step(dying, {.repeats = true, .takes_worst = true}) == "110");
  CHECK(step(dying, {.repeats = true, .takes_worst = true}) == "");
  DyingRunOf<FailingSample> relieved("include all blocks\nmaterial criterion = on\n");
  fail(relieved, 1.2, 1.1);
  CHECK(step(relieved, {.takes_worst = true}) == "110");
  fail(relieved, 1.2, 0.9);
  CHECK(step(relieved, {.repeats = true, .takes_worst = true}) == "");
  // What fades is not the worst again; other criteria kill all that meet them.
  DyingRunOf<FailingSample> fading("include all blocks\nmaterial criterion = on\ndeath steps = 2\n");
  fail(fading, 1.1, 1.2);
  CHECK(step(fading, {.takes_worst = true}) == "");
  CHECK(step(fading, {.repeats = true, .takes_worst = true}) == "111");
  CHECK(step(fading, {.repeats = true, .takes_worst = true}) == "110");
  DyingRunOf<FailingSample> all("element = 103 107\ncriterion is always true\n");
  CHECK(step(all, {.takes_worst = true}) == "103 107");
}

TEST_CASE("another look at a time takes the criteria that were due there", "[core][death]") {
  DyingRun dying("block = soft\ncriterion is element value of von_mises > 20\ncheck step interval = 3\n");
  CHECK(dying.deaths.step(dying.run.state, {}).empty());  // step 0
  dying.run.set_point_value(0, 3, 0, 21.0);
  CHECK(dying.deaths.step(dying.run.state, {}, {.repeats = true}).size() == 1);
  dying.run.state.step = 1;
  dying.run.state.time = 1.0;
  dying.run.set_point_value(0, 5, 0, 21.0);
  CHECK(dying.deaths.step(dying.run.state, {}).empty());
  CHECK(dying.deaths.step(dying.run.state, {}, {.repeats = true}).empty());
}

TEST_CASE("death criteria that mean nothing are errors", "[core][death]") {
  CHECK(DyingRun("block = soft\ncriterion is element value of von_mise > 1\n")
            .deck.messages()
            .find("no element variable 'von_mise' is known here") != std::string::npos);
  CHECK(DyingRun("block = soft\ncriterion is element value of eqps > 1\n")
            .deck.messages()
            .find("no element of the set has eqps") != std::string::npos);
  CHECK(DyingRun("block = soft\nmaterial criterion = on\n")
            .deck.messages()
            .find("no element of the set has a material that fails by itself") != std::string::npos);
  CHECK(DyingRun("block = soft\n").deck.messages().find("has no criterion") != std::string::npos);
}

TEST_CASE("ranks look at their own elements, and all know who dies", "[core][death]") {
  std::mutex checking;
  ThreadRanks(2).run([&](Ranks& ranks) {
    // The first rank has "soft", the second "hard".
    DyingRun dying(
        "block = soft hard\ncriterion is min nodal value of coordinates(x) = 1\ndeath on inversion = on\n");
    const RankShare share(ranks, dying.run.model, {});
    dying.deaths.share_among(share);
    // What a rank has of the others' nodes and elements is old.
    if (ranks.is_root()) {
      dying.run.state.blocks[0].life[0](6) = 0.0;
    } else {
      for (Eigen::Index node = 0; node < dying.run.state.coordinates.cols(); ++node) {
        if (dying.run.state.coordinates(0, node) > 4.0) dying.run.state.coordinates(0, node) = 1.0;
      }
    }
    const std::string died = dying.step(), died_then = dying.step();
    const std::lock_guard lock(checking);
    CHECK(share.has_element({0}) == ranks.is_root());
    CHECK(share.has_element({10}) != ranks.is_root());
    CHECK(died == "102 107 111");
    CHECK(dying.life(6) == 0.0);
    CHECK(died_then.empty());
  });
}

TEST_CASE("global values alone need more than a rank's own elements, when they are due", "[core][death]") {
  DyingRun by_elements("block = soft\ncriterion is max nodal value of coordinates(x) > 100\n");
  CHECK_FALSE(by_elements.deaths.reads_all(by_elements.run.state));
  DyingRun by_all(
      "block = soft\ncriterion is global value of kinetic_energy > 1e9\ncheck step interval = 2\n");
  CHECK(by_all.deaths.reads_all(by_all.run.state));
  by_all.step();
  CHECK_FALSE(by_all.deaths.reads_all(by_all.run.state));
}
