// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "core/output/output_table.hpp"

namespace contactsim {

namespace {

using Values = std::span<double>;

// Sets the vectors of a range of nodes to value(node).
template <class Value>
void fill_vectors(const EntityRange& range, Values values, Value value) {
  for (std::size_t i = 0; i < range.count; ++i) {
    Eigen::Map<Eigen::Vector3d>(values.data() + 3 * i) = value(static_cast<Eigen::Index>(range.first + i));
  }
}

template <Eigen::Matrix3Xd State::*vectors>
void fill_from_state(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return (m.state.*vectors).col(n); });
}

// Without contact there is an array of no columns.
Eigen::Vector3d contact_force(const State& state, Eigen::Index node) {
  if (node >= state.forces.contact.cols()) return Eigen::Vector3d::Zero();
  return state.forces.contact.col(node);
}

Eigen::Vector3d acting_force(const State& state, Eigen::Index node) {
  return state.forces.internal.col(node) + state.forces.external.col(node) + contact_force(state, node);
}

// Nodes without elements have next to no mass, which counts as none.
double mass_of(const Model& model, Eigen::Index node) {
  const double mass = model.mass(0, node);
  return mass > least_mass ? mass : 0.0;
}

Eigen::Vector3d inertial_force(const OutputMoment& m, Eigen::Index node) {
  return mass_of(m.model, node) * m.state.acceleration.col(node);
}

bool is_held(const Model& model, Eigen::Index node) {
  const auto nodes = model.kinematics.nodes();
  return std::binary_search(nodes.begin(), nodes.end(), NodeIndex{static_cast<std::uint32_t>(node)});
}

void fill_displacement(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) {
    return Eigen::Vector3d(m.state.coordinates.col(n) - m.model.mesh->coordinates().col(n));
  });
}

void fill_model_coordinates(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return m.model.mesh->coordinates().col(n); });
}

void fill_mass(const OutputMoment& m, const EntityRange& range, Values values) {
  for (std::size_t i = 0; i < range.count; ++i)
    values[i] = mass_of(m.model, static_cast<Eigen::Index>(range.first + i));
}

void fill_residual(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return acting_force(m.state, n); });
}

void fill_reaction(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) -> Eigen::Vector3d {
    if (!is_held(m.model, n)) return Eigen::Vector3d::Zero();
    return inertial_force(m, n) - acting_force(m.state, n);
  });
}

void fill_inertial(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return inertial_force(m, n); });
}

void fill_external(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return m.state.forces.external.col(n); });
}

void fill_internal(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values,
               [&](Eigen::Index n) { return Eigen::Vector3d(-m.state.forces.internal.col(n)); });
}

void fill_contact(const OutputMoment& m, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return contact_force(m.state, n); });
}

}  // namespace

std::span<const OutputRow> nodal_output_rows() {
  constexpr auto node = FieldLocation::node;
  constexpr auto vector = FieldShape::vector;
  static constexpr std::array rows{
      OutputRow{"displacement", node, vector, false, fill_displacement, "From the mesh to now [length]"},
      OutputRow{"velocity", node, vector, false, fill_from_state<&State::velocity>, "[length/time]"},
      OutputRow{"acceleration", node, vector, false, fill_from_state<&State::acceleration>,
                "[length/time^2]"},
      OutputRow{"coordinates", node, vector, false, fill_from_state<&State::coordinates>,
                "Where the node is now [length]"},
      OutputRow{"model_coordinates", node, vector, false, fill_model_coordinates,
                "Where the mesh has the node [length]"},
      OutputRow{"mass", node, FieldShape::scalar, false, fill_mass, "Lumped mass [mass]"},
      OutputRow{"residual", node, vector, false, fill_residual,
                "external - internal + contact force: what is left to accelerate or to be held [force]"},
      OutputRow{"reaction", node, vector, false, fill_reaction,
                "What holds or drives the node: mass x acceleration - residual; 0 at free nodes [force]"},
      OutputRow{"force_external", node, vector, false, fill_external, "Loads and gravity [force]"},
      OutputRow{"force_internal", node, vector, false, fill_internal,
                "Resistance of the elements, against the motion: mass x acceleration = external - internal + "
                "contact force + reaction [force]"},
      OutputRow{"force_contact", node, vector, false, fill_contact, "As it acts on the node [force]"},
      OutputRow{"force_inertial", node, vector, false, fill_inertial, "mass x acceleration [force]"},
  };
  return rows;
}

}  // namespace contactsim
