// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/rigid_output.hpp"

#include <fmt/format.h>

#include <array>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

using Value = double (*)(const RigidBody&, const RigidBodyState&, Eigen::Index component);

struct Row {
  std::string_view name, dimension;
  Value value;
};

constexpr std::array rows{
    Row{"displ", "[length]",
        [](const RigidBody& body, const RigidBodyState& s, Eigen::Index c) {
          return s.position(c) - body.centre(c);
        }},
    Row{"vel", "[length/time]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.now.velocity(c); }},
    Row{"a", "[length/time^2]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.acceleration(c); }},
    Row{"rotd", "[1]", [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.angle(c); }},
    Row{"rotv", "[1/time]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.now.turning(c); }},
    Row{"rota", "[1/time^2]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.angular_acceleration(c); }},
    Row{"react", "[force]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.reaction(c); }},
    Row{"rreact", "[force length]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.reaction_moment(c); }},
    Row{"fext", "[force]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.force(c); }},
    Row{"mext", "[force length]",
        [](const RigidBody&, const RigidBodyState& s, Eigen::Index c) { return s.moment(c); }},
};

double quaternion_part(const RigidBody&, const RigidBodyState& state, Eigen::Index component) {
  return component == 0 ? state.orientation.w() : state.orientation.vec()(component - 1);
}

// At the time of output the state may not have bodies yet: before the run has started.
OutputVariable make_variable(std::string name, std::size_t body, const Row& row, Eigen::Index component) {
  OutputVariable variable;
  variable.name = std::move(name);
  variable.dimension = row.dimension;
  variable.fill = [body, value = row.value, component](const OutputContext& context, const EntityRange&,
                                                       std::span<double> values) {
    const bool is_known = body < context.state.rigid.size();
    values[0] =
        is_known ? value(context.model.rigid.bodies[body], context.state.rigid[body], component) : 0.0;
  };
  return variable;
}

}  // namespace

std::vector<OutputVariable> rigid_variables(const Model& model) {
  std::vector<OutputVariable> variables;
  for (std::size_t body = 0; body < model.rigid.bodies.size(); ++body) {
    const std::string name = fold(model.rigid.bodies[body].name);
    for (const Row& row : rows) {
      for (Eigen::Index c = 0; c < 3; ++c)
        variables.push_back(make_variable(fmt::format("{}{}_{}", row.name, "xyz"[c], name), body, row, c));
    }
    for (Eigen::Index c = 0; c < 4; ++c)
      variables.push_back(
          make_variable(fmt::format("qvec{}_{}", c + 1, name), body, {"qvec", "[1]", quaternion_part}, c));
  }
  return variables;
}

}  // namespace contactsim
