// SPDX-License-Identifier: BSD-3-Clause
#include "core/death/death_criteria.hpp"

#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/johnson_cook.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Ten hexahedra of eight integration points in a row along x, of a law that fails by its damage, and three
/// of one point beside them, which are elastic.
struct PointsRun {
  PointsRun()
      : mesh(MeshBuilder()
                 .add_hexes({.id = 1, .cells = {10, 1, 1}, .size = {10, 1, 1}})
                 .add_hexes({.id = 2, .cells = {3, 1, 1}, .origin = {0, 5, 0}, .size = {3, 1, 1}})
                 .build()) {
    model.mesh = &mesh;
    ElementProperties properties;
    properties.law = FailingJohnsonCookLaw{};
    model.blocks.push_back(make_solid_block(mesh, 0, hex8_fully_integrated, properties));
    properties.law = ElasticLaw{};
    model.blocks.push_back(make_solid_block(mesh, 1, hex8_mean_quadrature, properties));
    model.mass = lumped_mass(mesh, model.blocks);
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
  }

  /// Sets a number of a point of an element of the first block: 0 is the stress xx, 7 the damage.
  void set(std::size_t element, std::size_t point, std::size_t place, double value) {
    const StateLayout& layout = model.blocks[0].layout;
    state.blocks[0].batch(layout, element / n_lanes)[point * layout.point_size + place](
        static_cast<Eigen::Index>(element % n_lanes)) = value;
  }

  Mesh mesh;
  Model model;
  State state;
};

VariableTest test_that(const std::string& name, Comparison comparison, double value,
                       const std::string& component = "") {
  return {{{name, {}}, component, std::nullopt}, comparison, value};
}

/// The positions of the elements that one criterion marks, among those of a set.
class Marking {
 public:
  Marking(const PointsRun& run, const DeathCriterion& criterion, std::vector<ElementIndex> elements)
      : run_(run), elements_(std::move(elements)), variables_(run.model) {
    death_.criteria = {criterion};
    criteria_.emplace(death_, elements_, variables_, diagnostics_);
  }
  Marking(const Marking&) = delete;
  Marking& operator=(const Marking&) = delete;

  std::string marked() const {
    std::vector<std::uint8_t> marks(run_.mesh.n_elements(), 0);
    criteria_->mark({run_.model, run_.state}, marks);
    std::string text;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (marks[i] != 0) text += std::to_string(i) + " ";
    }
    return text;
  }
  WorstElement worst(std::vector<std::uint8_t> may_die) const {
    std::vector<std::uint8_t> marks(run_.mesh.n_elements(), 0);
    WorstElement found;
    criteria_->mark_worst({run_.model, run_.state}, may_die, marks, found);
    CHECK(std::count(marks.begin(), marks.end(), 1) == 0);
    return found;
  }
  std::string messages() const { return contactsim::messages(diagnostics_); }

 private:
  const PointsRun& run_;
  std::vector<ElementIndex> elements_;
  OutputVariables variables_;
  ElementDeath death_;
  Diagnostics diagnostics_;
  std::optional<DeathCriteria> criteria_;
};

const std::vector<ElementIndex> every_element{{0}, {1}, {2}, {3},  {4},  {5}, {6},
                                              {7}, {8}, {9}, {10}, {11}, {12}};

}  // namespace

TEST_CASE("of element values the mean of the points counts, unless some may remain", "[core][death]") {
  PointsRun run;
  for (std::size_t point = 0; point < 8; ++point) run.set(3, point, 0, point < 3 ? 24.0 : 0.0);  // mean 9
  for (std::size_t point = 0; point < 8; ++point) run.set(9, point, 0, 11.0);
  const VariableTest beyond_8 = test_that("von_mises", Comparison::greater, 8.0);
  const auto marked = [&](std::optional<std::int64_t> remaining) {
    return Marking(run, ElementCriterion{beyond_8, remaining}, every_element).marked();
  };
  CHECK(marked(std::nullopt) == "3 9 ");
  CHECK(marked(0) == "9 ");
  CHECK(marked(4) == "9 ");  // three of element 3 meet the test: five remain
  CHECK(marked(5) == "3 9 ");
  // An element none of whose points meets the test does not die, however many may remain.
  CHECK(marked(8) == "3 9 ");
}

TEST_CASE("any component of a variable will do, or the one that is named", "[core][death]") {
  PointsRun run;
  for (std::size_t point = 0; point < 8; ++point) {
    run.set(2, point, 1, -30.0);  // yy
    run.set(8, point, 0, -30.0);  // xx, in another batch
  }
  const auto marked = [&](const std::string& component) {
    const Marking marking(run, ElementCriterion{test_that("stress", Comparison::less, -20.0, component), {}},
                          every_element);
    CHECK(marking.messages() == "");
    return marking.marked();
  };
  CHECK(marked("") == "2 8 ");
  CHECK(marked("yy") == "2 ");
  CHECK(marked("xx") == "8 ");
  CHECK(marked("zz") == "");
}

TEST_CASE("only elements of the set are marked, in whatever stretches they come", "[core][death]") {
  const PointsRun run;
  const VariableTest at_rest = test_that("von_mises", Comparison::less_equal, 0.0);
  CHECK(Marking(run, ElementCriterion{at_rest, {}}, {{0}, {1}, {4}, {8}, {9}, {10}, {12}}).marked() ==
        "0 1 4 8 9 10 12 ");
  CHECK(Marking(run, ElementCriterion{at_rest, 3}, {{7}, {11}}).marked() == "7 11 ");
  CHECK(Marking(run, ElementCriterion{at_rest, {}}, {}).marked() == "");
  CHECK(Marking(run, AlwaysCriterion{}, {{2}, {12}}).marked() == "2 12 ");
}

TEST_CASE("values of nodes are reduced a component at a time", "[core][death]") {
  // Element i has its nodes at x = i and i + 1, y = 0 and 1, z = 0 and 1; the second block at y = 5 and 6.
  const PointsRun run;
  using R = NodalCriterion::Reduction;
  const auto marked = [&](R reduction, const VariableTest& test) {
    return Marking(run, NodalCriterion{reduction, test}, every_element).marked();
  };
  CHECK(marked(R::average, test_that("coordinates", Comparison::equal, 2.5, "x")) == "2 12 ");
  CHECK(marked(R::maximum, test_that("coordinates", Comparison::greater_equal, 9.0, "x")) == "8 9 ");
  CHECK(marked(R::minimum, test_that("coordinates", Comparison::less_equal, 1.0, "x")) == "0 1 10 11 ");
  // The components are compared each, not their length: all of y up to 6 are no 6.4.
  CHECK(marked(R::maximum, test_that("coordinates", Comparison::greater, 6.0)) == "6 7 8 9 ");
  CHECK(marked(R::minimum, test_that("coordinates", Comparison::equal, 5.0)) == "5 10 11 12 ");
}

TEST_CASE("a material criterion is the test of what laws fail by, of elements that have them",
          "[core][death]") {
  PointsRun run;
  for (std::size_t point = 0; point < 8; ++point) run.set(4, point, 7, point == 0 ? 0.9 : 1.1);
  for (std::size_t point = 0; point < 2; ++point) run.set(6, point, 7, 5.0);  // the mean is 1.25
  const auto marked = [&](std::optional<std::int64_t> remaining) {
    const Marking marking(run, MaterialCriterion{remaining}, every_element);
    CHECK(marking.messages() == "");
    return marking.marked();
  };
  CHECK(marked(std::nullopt) == "");  // no point may remain
  CHECK(marked(1) == "4 ");
  CHECK(marked(6) == "4 6 ");
}

TEST_CASE("the worst is the one of the largest mean that may die, the first of equal ones", "[core][death]") {
  PointsRun run;
  for (std::size_t point = 0; point < 8; ++point) {
    for (const std::size_t element : {1u, 5u, 8u}) run.set(element, point, 7, element == 1 ? 1.0 : 1.5);
  }
  const Marking marking(run, MaterialCriterion{}, every_element);
  std::vector<std::uint8_t> may_die(13, 1);
  const WorstElement worst = marking.worst(may_die);
  CHECK(worst.element == ElementIndex{5});
  CHECK(worst.value == Approx(1.5));
  may_die[5] = 0;
  CHECK(marking.worst(may_die).element == ElementIndex{8});
  may_die[8] = 0;
  CHECK(marking.worst(may_die).element == ElementIndex{1});
  may_die[1] = 0;
  CHECK_FALSE(marking.worst(may_die).element);
}

TEST_CASE("a criterion that says nothing of the set is an error and kills none", "[core][death]") {
  const PointsRun run;
  const Marking unknown(run, ElementCriterion{test_that("von_mise", Comparison::greater, -1.0), {}},
                        every_element);
  CHECK(unknown.messages().starts_with("error: no element variable 'von_mise' is known here"));
  CHECK(unknown.marked() == "");
  const Marking elastic(run, ElementCriterion{test_that("eqps", Comparison::greater, -1.0), {}},
                        {{10}, {12}});
  CHECK(elastic.messages() == "error: no element of the set has eqps\n");
  CHECK(elastic.marked() == "");
  const Marking tough(run, MaterialCriterion{}, {{10}, {12}});
  CHECK(
      tough.messages() ==
      "error: MATERIAL CRITERION: no element of the set has a material that fails by itself; ml_ep_fail and "
      "johnson_cook with d1 to d4 do; CRITERION IS ELEMENT VALUE OF eqps >= <limit> kills by plastic "
      "strain\n");
  // An empty set has been warned of.
  CHECK(Marking(run, MaterialCriterion{}, {}).messages() == "");
  CHECK(Marking(run, ElementCriterion{test_that("eqps", Comparison::greater, 0.0), {}}, {}).messages() == "");
}
