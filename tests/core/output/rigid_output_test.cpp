// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/rigid_output.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A body "Sled" and its state, of numbers that tell where they come from.
struct OneBody {
  Mesh mesh;
  Model model;
  State state;

  OneBody() {
    model.mesh = &mesh;
    RigidBody body;
    body.name = "Sled";
    body.centre = {1, 1, 1};
    model.rigid.bodies.push_back(body);
    RigidBodyState now;
    now.position = {2, 3, 4};
    now.orientation = Eigen::Quaterniond(0.5, 0.1, 0.2, 0.3);
    now.now.velocity = {10, 11, 12};
    now.now.turning = {20, 21, 22};
    now.acceleration = {30, 31, 32};
    now.reaction = {40, 41, 42};
    now.reaction_moment = {50, 51, 52};
    now.force = {60, 61, 62};
    now.moment = {70, 71, 72};
    now.angle = {80, 81, 82};
    now.angular_acceleration = {90, 91, 92};
    state.rigid.push_back(now);
  }

  double value(const std::string& name) const {
    const std::vector<OutputVariable> variables = rigid_variables(model);
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const OutputVariable& variable) { return variable.name == name; });
    REQUIRE(found != variables.end());
    CHECK(found->location == FieldLocation::global);
    double value = -1.0;
    found->fill({model, state}, {}, {&value, 1});
    return value;
  }
};

}  // namespace

TEST_CASE("a rigid body has its motion and what acts on it as globals", "[core][output]") {
  const OneBody one;
  CHECK(one.value("displx_sled") == 1);
  CHECK(one.value("displz_sled") == 3);
  CHECK(one.value("vely_sled") == 11);
  CHECK(one.value("az_sled") == 32);
  CHECK(one.value("rotdx_sled") == 80);
  CHECK(one.value("rotvy_sled") == 21);
  CHECK(one.value("rotaz_sled") == 92);
  CHECK(one.value("reactx_sled") == 40);
  CHECK(one.value("rreacty_sled") == 51);
  CHECK(one.value("fextz_sled") == 62);
  CHECK(one.value("mextx_sled") == 70);
  CHECK(one.value("qvec1_sled") == 0.5);
  CHECK(one.value("qvec4_sled") == 0.3);
}

TEST_CASE("before the run has begun the globals of rigid bodies are 0", "[core][output]") {
  OneBody one;
  one.state.rigid.clear();
  CHECK(one.value("displx_sled") == 0);
  CHECK(one.value("qvec1_sled") == 0);
}

TEST_CASE("no body, no variables; names of several do not meet", "[core][output]") {
  OneBody one;
  one.model.rigid.bodies.push_back(one.model.rigid.bodies[0]);
  one.model.rigid.bodies[1].name = "wall";
  std::vector<std::string> names;
  for (const OutputVariable& variable : rigid_variables(one.model)) names.push_back(variable.name);
  CHECK(names.size() == 2 * 34);
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  one.model.rigid.bodies.clear();
  CHECK(rigid_variables(one.model).empty());
}
