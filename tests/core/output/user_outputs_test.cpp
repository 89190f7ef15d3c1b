// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/user_outputs.hpp"

#include <cmath>

#include "core/output/variable_selection.hpp"
#include "support/catch.hpp"
#include "support/parsed_deck.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string functions = R"deck(
  begin function twice_v
    type is analytic
    expression variable: v = nodal velocity(x)
    expression variable: t = global time
    evaluate expression = "2 * v + t"
  end
  begin function peak
    type is analytic
    expression variable: old = element peak_vm
    expression variable: vm = element von_mises
    evaluate expression = "max(old, vm)"
  end
  begin function ramp
    type is analytic
    evaluate expression = "10 * x"
  end
  begin function mixed
    type is analytic
    expression variable: v = element volume
    evaluate expression = "v"
  end
)deck";

/// A sample run with the user output of some region lines.
class UserRun {
 public:
  explicit UserRun(const std::string& region_lines)
      : deck_(parsed("begin sierra\n" + functions + "begin presto procedure p\nbegin presto region r\n" +
                     region_lines + "end\nend\nend\n")),
        scope_{deck_.simulation, deck_.simulation.procedures.at(0).regions.at(0), {}, run.mesh, diagnostics_},
        outputs_(scope_, variables) {}

  /// The values of a variable after a computation.
  std::vector<double> values(FieldLocation location, const std::string& name, const EntityRange& range = {}) {
    const OutputVariable* variable = variables.find(location, name);
    REQUIRE(variable != nullptr);
    std::vector<double> values(range.count * static_cast<std::size_t>(variable->n_components));
    fill({variable, {}, {}}, run.context(), range, values);
    return values;
  }
  double global(const std::string& name) { return values(FieldLocation::global, name).at(0); }
  /// Goes on to the next step.
  void compute(bool are_needed = true) {
    ++run.state.step;
    outputs_.compute(run.context(), are_needed);
    outputs_.compute(run.context(), are_needed);
  }
  std::string messages() const { return contactsim::messages(diagnostics_); }

  SampleRun run;
  OutputVariables variables{run.model};

 private:
  ParsedDeck deck_;
  Diagnostics diagnostics_;
  ConditionScope scope_;
  UserOutputs outputs_;
};

using Values = std::vector<double>;

}  // namespace

TEST_CASE("globals are made from the values of a set", "[core][output]") {
  UserRun user(R"deck(
    begin user output
      block = hard
      compute global total as sum of element volume
      compute global most as max of element stress(xx)
      compute global least as min of element stress(xx)
      compute global mean as average of element stress(xx)
      compute global size as max absolute value of element stress(xx)
      compute global norm as l2norm of element stress(xx)
      compute global spread as variance of element stress(xx)
    end
    begin user output
      node set = wall
      compute global load as sum of nodal force_external
    end
    begin user output
      compute global all as sum of element element_mass
    end
  )deck");
  CHECK(user.messages().empty());
  user.run.set_point_value(1, 0, 0, -4.0);
  user.run.set_point_value(1, 1, 0, 3.0);
  user.run.state.forces.external.setConstant(0.5);
  user.compute();
  CHECK(user.global("total") == Approx(2.0));
  CHECK(user.global("most") == 3.0);
  CHECK(user.global("least") == -4.0);
  CHECK(user.global("mean") == Approx(-0.5));
  CHECK(user.global("size") == 4.0);
  CHECK(user.global("norm") == Approx(5.0));
  CHECK(user.global("spread") == Approx(12.25));
  // Six nodes at the wall: four of the row below, two above.
  CHECK(user.values(FieldLocation::global, "load") == Values{3, 3, 3});
  // 9 of density 2, 2 of density 3.
  CHECK(user.global("all") == Approx(24.0));
}

TEST_CASE("functions make variables of nodes, elements and the whole", "[core][output]") {
  UserRun user(R"deck(
    begin user variable w
      type = node real length = 1
      initial value = -1
    end
    begin user output
      node set = wall
      compute nodal w as function twice_v
      compute global g as function ramp
      compute global h from expression "g + momentum_y * 2"
    end
  )deck");
  CHECK(user.messages().empty());
  user.run.state.time = 3.0;
  user.run.state.momentum = {0, 4, 0};
  user.run.state.velocity.setConstant(0.25);
  user.compute();
  const auto wall = user.run.mesh.node_sets()[0].nodes.front();
  CHECK(user.values(FieldLocation::node, "w", {0, wall.value, 1, {}}) == Values{3.5});
  // A node outside the set keeps its initial value.
  CHECK(user.values(FieldLocation::node, "w", {0, wall.value + 1, 1, {}}) == Values{-1});
  CHECK(user.global("g") == 30.0);
  CHECK(user.global("h") == 38.0);
}

TEST_CASE("what is computed at every step may keep its peak", "[core][output]") {
  UserRun user(R"deck(
    begin user output
      compute element peak_vm as function peak
      compute at every step
    end
    begin user output
      compute global written as max of element peak_vm
    end
  )deck");
  CHECK(user.messages().empty());
  for (const double stress : {2.0, 7.0, 1.0}) {
    user.run.set_point_value(0, 8, 0, stress);
    user.compute(false);
  }
  CHECK(user.values(FieldLocation::element, "peak_vm", {0, 7, 1, {}}) == Values{0});
  CHECK(user.values(FieldLocation::element, "peak_vm", {0, 8, 1, {}})[0] == Approx(7.0));
  CHECK(user.global("written") == 0.0);
  user.compute(true);
  CHECK(user.global("written") == Approx(7.0));
}

TEST_CASE("element values go to nodes by volume, integration points to their mean", "[core][output]") {
  UserRun user(R"deck(
    begin user output
      extrapolate element variable element_mass to nodal variable at_nodes
      compute element same as volume weighted average of element stress
    end
  )deck");
  CHECK(user.messages().empty());
  user.run.set_point_value(0, 3, 5, 8.0);
  user.compute();
  // The first node of the mesh is in one element of the soft block only.
  CHECK(user.values(FieldLocation::node, "at_nodes")[0] == Approx(2.0));
  const auto on_top = user.run.mesh.blocks()[1].element_nodes(0);
  double least = 9.0, greatest = 0.0;
  for (const NodeIndex node : on_top) {
    const double value = user.values(FieldLocation::node, "at_nodes", {0, node.value, 1, {}})[0];
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  CHECK(least == Approx(2.5));  // between elements of mass 2 and 3
  CHECK(greatest == Approx(3.0));
  CHECK(user.values(FieldLocation::element, "same", {0, 3, 1, {}}) == Values{0, 0, 0, 0, 0, 8});
}

TEST_CASE("user variables have their shape, blocks and values", "[core][output]") {
  UserRun user(R"deck(
    begin user variable v
      type = element vector
      initial value = 1 2 3
      block = hard
    end
    begin user variable n
      type = global real length = 2
    end
  )deck");
  CHECK(user.messages().empty());
  CHECK(user.variables.find(FieldLocation::element, "v")->in_blocks == std::vector<std::uint8_t>{0, 1});
  CHECK(user.values(FieldLocation::element, "v", {1, 0, 2, {}}) == Values{1, 2, 3, 1, 2, 3});
  CHECK(user.variables.find(FieldLocation::global, "n")->shape == FieldShape::list);
}

TEST_CASE("what cannot be computed is said", "[core][output]") {
  const auto messages = [](const std::string& lines) {
    const std::string all = UserRun("begin user output\n" + lines + "\nend\n").messages();
    return all.substr(all.find(": ") + 2);
  };
  CHECK(messages("compute global g as sum of nodal pressure").starts_with("warning: no nodal variable"));
  CHECK(messages("compute global g from expression \"1 +\"").starts_with("error: the expression of g: "));
  CHECK(
      messages("compute global g from expression \"enthalpy\"").starts_with("error: the expression of g: "));
  CHECK(messages("compute nodal n as function mixed")
            .starts_with("warning: a nodal value cannot be made from the element variable volume"));
  CHECK(messages("node set = wall\n compute global g as sum of element volume")
            .find("the node set wall holds no elements") != std::string::npos);
}
