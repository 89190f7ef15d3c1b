// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/rigid_body_commands.hpp"

namespace contactsim {

namespace {

using B = RigidBodyDefinition;

void read_inertia(Arguments& arguments, B& body) {
  std::array<double, 6> inertia{};
  for (double& entry : inertia) entry = arguments.real();
  body.inertia = inertia;
}

void read_point_mass(Arguments& arguments, B& body) {
  AttachedPointMass mass{arguments.non_negative(), {}};
  arguments.expect("at");
  arguments.expect("location");
  arguments.skip_separator();
  mass.location = arguments.vector();
  body.point_masses.push_back(mass);
}

}  // namespace

const Table<RigidBodyDefinition>& rigid_body_table() {
  static const Table<B> table({
      row("reference location", read::vector3, &B::reference_location,
          "Reference point, else the centre of mass [length]"),
      row("include nodes in", read::names_of(NameKind::node_set), &B::node_sets,
          "Node sets whose nodes belong to the body"),
      row("mass", read::positive, &B::mass, "Mass, else that of the member blocks [mass]"),
      row<B>("inertia", "= <ixx> <iyy> <izz> <ixy> <iyz> <izx>", read_inertia,
             "Inertia about the reference point, else that of the member blocks [mass length^2]", "none")
          .once(),
      row<B>("point mass", "= <m> AT LOCATION <x> <y> <z>", read_point_mass,
             "Adds a mass [mass] at a place [length]", "none"),
      row("magnitude", read::real, &B::magnitude, "Initial speed along DIRECTION [length/time]", "none"),
      row("direction", read::name_of(NameKind::direction), &B::direction,
          "Direction of the initial velocity"),
      row("angular velocity", read::real, &B::angular_velocity,
          "Initial turning rate about CYLINDRICAL AXIS [1/time]", "none"),
      row("cylindrical axis", read::name_of(NameKind::axis), &B::cylindrical_axis,
          "Axis of the initial turning"),
  });
  return table;
}

}  // namespace contactsim
