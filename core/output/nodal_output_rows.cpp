// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "core/dynamics/energy_balance.hpp"
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
void fill_from_state(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return (context.state.*vectors).col(n); });
}

// Nodes without elements have next to no mass, which counts as none.
double mass_of(const Model& model, Eigen::Index node) {
  const double mass = model.mass(node);
  return mass > minimum_nodal_mass ? mass : 0.0;
}

Eigen::Vector3d inertial_force(const OutputContext& context, Eigen::Index node) {
  return mass_of(context.model, node) * context.state.acceleration.col(node);
}

bool is_held(const Model& model, Eigen::Index node) {
  const auto nodes = model.kinematic_constraints.nodes();
  return std::binary_search(nodes.begin(), nodes.end(), NodeIndex{static_cast<std::uint32_t>(node)});
}

// Nodes of a model that nothing turns in have no rotations.
template <class Value>
void fill_rotations(const OutputContext& context, const EntityRange& range, Values values, Value value) {
  fill_vectors(range, values, [&](Eigen::Index n) -> Eigen::Vector3d {
    if (!context.state.rotations.exist()) return Eigen::Vector3d::Zero();
    return value(context.state.rotations, n);
  });
}

template <Eigen::Matrix3Xd NodalRotations::*vectors>
void fill_from_rotations(const OutputContext& context, const EntityRange& range, Values values) {
  fill_rotations(context, range, values, [](const NodalRotations& r, Eigen::Index n) -> Eigen::Vector3d {
    return (r.*vectors).col(n);
  });
}

void fill_moment_external(const OutputContext& context, const EntityRange& range, Values values) {
  fill_rotations(context, range, values, [](const NodalRotations& r, Eigen::Index n) -> Eigen::Vector3d {
    return r.moments.external.col(n);
  });
}

void fill_moment_internal(const OutputContext& context, const EntityRange& range, Values values) {
  fill_rotations(context, range, values, [](const NodalRotations& r, Eigen::Index n) -> Eigen::Vector3d {
    return -r.moments.internal.col(n);
  });
}

void fill_moment_contact(const OutputContext& context, const EntityRange& range, Values values) {
  fill_rotations(context, range, values, [](const NodalRotations& r, Eigen::Index n) -> Eigen::Vector3d {
    return r.moments.contact_at(n);
  });
}

void fill_reaction_moment(const OutputContext& context, const EntityRange& range, Values values) {
  const auto held = context.model.rotation_constraints.nodes();
  fill_rotations(context, range, values, [&](const NodalRotations&, Eigen::Index n) -> Eigen::Vector3d {
    const NodeIndex node{static_cast<std::uint32_t>(n)};
    if (!std::binary_search(held.begin(), held.end(), node)) return Eigen::Vector3d::Zero();
    return reaction_moment_at(context.model, context.state, node);
  });
}

void fill_rotational_mass(const OutputContext& context, const EntityRange& range, Values values) {
  for (std::size_t i = 0; i < range.count; ++i) {
    const auto n = static_cast<Eigen::Index>(range.first + i);
    const double inertia = n < context.model.inertia.cols() ? context.model.inertia(n) : 0.0;
    values[i] = inertia > minimum_nodal_mass ? inertia : 0.0;
  }
}

void fill_displacement(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) {
    return Eigen::Vector3d(context.state.coordinates.col(n) - context.model.mesh->coordinates().col(n));
  });
}

void fill_model_coordinates(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return context.model.mesh->coordinates().col(n); });
}

void fill_mass(const OutputContext& context, const EntityRange& range, Values values) {
  for (std::size_t i = 0; i < range.count; ++i)
    values[i] = mass_of(context.model, static_cast<Eigen::Index>(range.first + i));
}

void fill_residual(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return context.state.forces.at(n); });
}

void fill_reaction(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) -> Eigen::Vector3d {
    if (!is_held(context.model, n)) return Eigen::Vector3d::Zero();
    return inertial_force(context, n) - context.state.forces.at(n);
  });
}

void fill_inertial(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return inertial_force(context, n); });
}

void fill_external(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return context.state.forces.external_at(n); });
}

void fill_internal(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values,
               [&](Eigen::Index n) { return Eigen::Vector3d(-context.state.forces.internal.col(n)); });
}

void fill_contact(const OutputContext& context, const EntityRange& range, Values values) {
  fill_vectors(range, values, [&](Eigen::Index n) { return context.state.forces.contact_at(n); });
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
      OutputRow{"rotational_displacement", node, vector, false, fill_from_rotations<&NodalRotations::angle>,
                "Angular velocity summed over time; 0 at nodes that do not turn [1]"},
      OutputRow{"rotational_velocity", node, vector, false, fill_from_rotations<&NodalRotations::velocity>,
                "Angular velocity [1/time]"},
      OutputRow{"rotational_acceleration", node, vector, false,
                fill_from_rotations<&NodalRotations::acceleration>, "Angular acceleration [1/time^2]"},
      OutputRow{"rotational_mass", node, FieldShape::scalar, false, fill_rotational_mass,
                "Lumped rotational inertia about any axis [mass length^2]"},
      OutputRow{"moment_external", node, vector, false, fill_moment_external,
                "Prescribed moments [force length]"},
      OutputRow{"moment_internal", node, vector, false, fill_moment_internal,
                "Resistance of the elements, against the turning [force length]"},
      OutputRow{"moment_contact", node, vector, false, fill_moment_contact,
                "As it acts on the node [force length]"},
      OutputRow{"reaction_moment", node, vector, false, fill_reaction_moment,
                "What holds or turns the node; 0 at free nodes [force length]"},
  };
  return rows;
}

}  // namespace contactsim
