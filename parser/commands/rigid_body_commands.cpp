// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/rigid_body_commands.hpp"

namespace contactsim {

namespace {

void read_inertia(Arguments& arguments, RigidBodyDefinition& body) {
  std::array<double, 6> inertia{};
  for (double& entry : inertia) entry = arguments.real();
  body.inertia = inertia;
}

void read_point_mass(Arguments& arguments, RigidBodyDefinition& body) {
  AttachedPointMass mass{arguments.non_negative(), {}};
  arguments.expect("at");
  arguments.expect("location");
  arguments.skip_separator();
  mass.location = arguments.vector();
  body.point_masses.push_back(mass);
}

}  // namespace

const Table<RigidBodyDefinition>& rigid_body_table() {
  static const Table<RigidBodyDefinition> table({
      row("reference location", read::vector3, &RigidBodyDefinition::reference_location,
          "Reference point, else the centre of mass [length]"),
      row("include nodes in", read::names_of(NameKind::node_set), &RigidBodyDefinition::node_sets,
          "Node sets whose nodes belong to the body"),
      row("mass", read::positive, &RigidBodyDefinition::mass, "Mass, else that of the member blocks [mass]"),
      row<RigidBodyDefinition>(
          "inertia", "= <ixx> <iyy> <izz> <ixy> <iyz> <izx>", read_inertia,
          "Inertia about the reference point, else that of the member blocks [mass length^2]", "none")
          .once(),
      row<RigidBodyDefinition>("point mass", "= <m> AT LOCATION <x> <y> <z>", read_point_mass,
                               "Adds a mass [mass] at a place [length]", "none"),
      row("magnitude", read::real, &RigidBodyDefinition::magnitude,
          "Initial speed along DIRECTION [length/time]", "none"),
      row("direction", read::name_of(NameKind::direction), &RigidBodyDefinition::direction,
          "Direction of the initial velocity"),
      row("angular velocity", read::real, &RigidBodyDefinition::angular_velocity,
          "Initial turning rate about CYLINDRICAL AXIS [1/time]", "none"),
      row("cylindrical axis", read::name_of(NameKind::axis), &RigidBodyDefinition::cylindrical_axis,
          "Axis of the initial turning"),
  });
  return table;
}

}  // namespace contactsim
