// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/conditions/direction.hpp"
#include "core/conditions/entity_faces.hpp"
#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/external_force.hpp"
#include "core/conditions/stored_values.hpp"
#include "core/definition/condition_loads.hpp"
#include "core/definition/region.hpp"
#include "core/elements/minimum_nodal_mass.hpp"

namespace contactsim {

namespace {

/// Compiles loads, each on its own.
class ExternalForceMaker {
 public:
  ExternalForceMaker(const ConditionScope& scope, const Eigen::RowVectorXd& mass,
                     const Eigen::RowVectorXd& inertia)
      : scope_(scope),
        mass_(mass),
        inertia_(inertia),
        made_(scope.region.viscous_dampings.empty() ? ExternalForce(scope.mesh)
                                                    : ExternalForce(scope.mesh, mass, inertia)) {}

  void add(const Gravity& gravity);
  void add(const NodalLoad& load);
  void add(const Pressure& pressure);
  void add(const Traction& traction);
  void add(const ViscousDamping& viscous);
  ExternalForce take() { return std::move(made_); }

 private:
  void find_faces_of(const EntitySet& set, const ConditionLabel& label, FaceLoad& load) const;
  std::vector<NodeIndex> nodes_of(const EntitySet& set, const ConditionLabel& label) const;
  std::optional<Eigen::Vector3d> find_vector(const DirectionChoice& choice) const;
  bool check_turn(std::span<const NodeIndex> nodes, const ConditionLabel& label) const;
  bool check_lines(const Pressure& pressure, const ConditionLabel& label) const;
  void add_error(const DeckLocation& location, std::string text, std::string hint = "") const {
    scope_.diagnostics.add_error(location, std::move(text), std::move(hint));
  }

  const ConditionScope& scope_;
  const Eigen::RowVectorXd& mass_;
  const Eigen::RowVectorXd& inertia_;
  ExternalForce made_;
};

std::optional<Eigen::Vector3d> ExternalForceMaker::find_vector(const DirectionChoice& choice) const {
  const auto direction = find_direction(choice, scope_);
  if (!direction) return std::nullopt;
  return sum_of_units(*direction);
}

/// A set that names nothing is all of the mesh.
std::vector<NodeIndex> ExternalForceMaker::nodes_of(const EntitySet& set, const ConditionLabel& label) const {
  if (set.names_something()) return find_nodes(set, label, scope_);
  EntitySet everything = set;
  everything.includes_all_blocks = true;
  return find_nodes(everything, label, scope_);
}

void ExternalForceMaker::add(const Gravity& gravity) {
  const ConditionLabel label{"the gravity", gravity.name.location};
  NodeLoad load;
  ScaledFunction function = gravity.function;
  function.scale_factor *= gravity.gravitational_constant;
  auto value = make_condition_function(function, label, scope_);
  const auto direction = find_vector(gravity.direction);
  load.nodes = nodes_of(gravity.set, label);
  if (!value || !direction) return;
  load.value = std::move(*value);
  load.direction = *direction;
  load.times = make_active_times(gravity.periods, scope_.time_stepping_blocks);
  for (const NodeIndex node : load.nodes) load.masses.push_back(mass_(node.value));
  made_.add(std::move(load));
}

/// Whether all nodes of a moment have rotations that it can act on.
bool ExternalForceMaker::check_turn(std::span<const NodeIndex> nodes, const ConditionLabel& label) const {
  const auto turns = [&](NodeIndex node) {
    return inertia_.cols() > 0 && inertia_(node.value) > minimum_nodal_mass;
  };
  const auto still = std::find_if_not(nodes.begin(), nodes.end(), turns);
  if (still == nodes.end()) return true;
  const bool none_turns = std::none_of(nodes.begin(), nodes.end(), turns);
  add_error(label.location,
            none_turns ? "the prescribed moment cannot act: none of its nodes has rotations: only those of "
                         "shells, beams and "
                         "point inertias do"
                       : fmt::format("the prescribed moment cannot act on node {}: it has no rotations",
                                     scope_.mesh.node_id(*still)),
            "forces on several nodes make a moment");
  return false;
}

void ExternalForceMaker::add(const NodalLoad& nodal) {
  const ConditionLabel label{nodal.is_moment ? "the prescribed moment" : "the prescribed force",
                             nodal.name.location};
  NodeLoad load;
  load.nodes = find_nodes(nodal.set, label, scope_);
  if (nodal.is_moment && !check_turn(load.nodes, label)) return;
  load.times = make_active_times(nodal.periods, scope_.time_stepping_blocks);
  const auto direction = find_direction(nodal.direction, scope_);
  const auto values = find_condition_values(nodal.function, nodal.variable,
                                            {nodal.direction.components, load.nodes, label}, scope_);
  if (!values || !direction) return;
  const std::vector<Eigen::Vector3d> units = unit_vectors(*direction);
  for (std::size_t i = 0; i < units.size(); ++i) {
    load.value = (*values)[std::min(i, values->size() - 1)];
    load.direction = units[i];
    nodal.is_moment ? made_.add_moment(load) : made_.add(load);
  }
}

bool ExternalForceMaker::check_lines(const Pressure& pressure, const ConditionLabel& label) const {
  if (pressure.force_output_name) {
    scope_.diagnostics.add_warning(
        "condition-ignored", label.location,
        fmt::format("the forces of the pressure alone are not written as '{}'", *pressure.force_output_name),
        "force_external holds those of all loads");
  }
  if (pressure.masking == Pressure::Masking::off) return true;
  add_error(label.location,
            fmt::format("the pressure has MASKING METHOD = {}, which is not supported",
                        pressure.masking == Pressure::Masking::on ? "ON" : "CONTACT"),
            "take faces out with REMOVE SURFACE");
  return false;
}

void ExternalForceMaker::find_faces_of(const EntitySet& set, const ConditionLabel& label,
                                       FaceLoad& load) const {
  std::vector<std::uint32_t> corners;
  for (const ElementSide face : find_faces(set, label, scope_)) {
    for (const auto& facet : scope_.mesh.side_facets(face)) {
      load.sides.push_back(face);
      load.faces.push_back(facet);
      for (const NodeIndex node : facet) corners.push_back(node.value);
    }
  }
  load.sums = NodeSums(corners, scope_.mesh.n_nodes());
}

void ExternalForceMaker::add(const Pressure& pressure) {
  const ConditionLabel label{"the pressure", pressure.name.location};
  if (!check_lines(pressure, label)) return;
  FaceLoad load;
  load.damping = pressure.velocity_damping_coefficient;
  load.times = make_active_times(pressure.periods, scope_.time_stepping_blocks);
  find_faces_of(pressure.set, label, load);
  MeshVariable variable = pressure.variable;
  if (!variable.object) variable.object = MeshVariable::Object::face;
  const auto values =
      find_condition_values(pressure.function, variable, {{}, load.sums.nodes(), label}, scope_);
  if (!values) return;
  load.value = values->front();
  made_.add(std::move(load));
}

void ExternalForceMaker::add(const Traction& traction) {
  const ConditionLabel label{"the traction", traction.name.location};
  FaceLoad load;
  load.direction = find_vector(traction.direction);
  load.times = make_active_times(traction.periods, scope_.time_stepping_blocks);
  auto value = make_condition_function(traction.function, label, scope_);
  find_faces_of(traction.set, label, load);
  if (!value || !load.direction) return;
  load.value = std::move(*value);
  made_.add(std::move(load));
}

void ExternalForceMaker::add(const ViscousDamping& viscous) {
  NodeDamping damping;
  damping.nodes = find_nodes(viscous.set, {"the viscous damping", viscous.name.location}, scope_);
  damping.coefficient = viscous.mass_damping_coefficient;
  damping.times = make_active_times(viscous.periods, scope_.time_stepping_blocks);
  made_.add(std::move(damping));
}

}  // namespace

ExternalForce make_external_force(const ConditionScope& scope, const Eigen::RowVectorXd& mass,
                                  const Eigen::RowVectorXd& inertia) {
  ExternalForceMaker maker(scope, mass, inertia);
  for (const Gravity& gravity : scope.region.gravities) maker.add(gravity);
  for (const NodalLoad& load : scope.region.nodal_loads) maker.add(load);
  for (const Pressure& pressure : scope.region.pressures) maker.add(pressure);
  for (const Traction& traction : scope.region.tractions) maker.add(traction);
  for (const ViscousDamping& damping : scope.region.viscous_dampings) maker.add(damping);
  return maker.take();
}

}  // namespace contactsim
