// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "contact/output/contact_output.hpp"
#include "support/contact_bodies.hpp"

namespace contactsim::test {

/// Bodies whose contact variables are looked at.
struct WatchedContact : ContactBodies {
  WatchedContact(const MeshBuilder& builder, const std::string& lines)
      : ContactBodies(builder, lines),
        output(contact, definition, model),
        variables(output.variables()),
        state(make_state(x, model.blocks, 0.0)) {}

  ContactOutput output;
  std::vector<OutputVariable> variables;
  State state;

  /// Brings the state to the bodies, as after a step.
  void take(std::int64_t step) {
    state.step = step;
    state.time = time;
    state.dt = dt;
    state.coordinates = x;
    state.velocity = v;
  }
  const OutputVariable& variable(const std::string& name) const {
    for (const OutputVariable& found : variables) {
      if (found.name == name) return found;
    }
    throw std::logic_error("there is no variable " + name);
  }
  Eigen::Vector3d global(const std::string& name) const {
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    const OutputVariable& found = variable(name);
    found.fill({model, state}, {}, std::span(values.data(), static_cast<std::size_t>(found.n_components)));
    return values;
  }
  /// [n_nodes] values of a nodal variable as columns of three.
  Eigen::Matrix3Xd nodal(const std::string& name) const {
    const OutputVariable& found = variable(name);
    const auto n = static_cast<std::size_t>(found.n_components);
    std::vector<double> values(n * mesh.n_nodes(), std::nan(""));
    found.fill({model, state}, {0, 0, mesh.n_nodes(), {}}, values);
    Eigen::Matrix3Xd made = Eigen::Matrix3Xd::Zero(3, x.cols());
    for (std::size_t i = 0; i < mesh.n_nodes(); ++i) {
      for (std::size_t k = 0; k < n; ++k)
        made(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) = values[i * n + k];
    }
    return made;
  }
};

}  // namespace contactsim::test
