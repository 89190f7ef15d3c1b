// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "contact/output/contact_output.hpp"

namespace contactsim {

namespace {

void set(const Eigen::Vector3d& vector, double* values) {
  for (int i = 0; i < 3; ++i) values[i] = vector[i];
}

/// A unit vector, or nothing.
void set_direction(const Eigen::Vector3d& vector, double* values) {
  const double length = vector.norm();
  set(length > 0.0 ? Eigen::Vector3d(vector / length) : Eigen::Vector3d::Zero(), values);
}

/// Of a total that touches [length].
Eigen::Vector3d centre_of(const ContactTotal& total) { return total.centre / total.normal_sum; }

/// The point of the line of action of a force that is nearest to the centre: of all places at which the force
/// alone would have the moment, but for the part of it along the force. Source: least moment, as of the
/// wrench in Featherstone, Rigid Body Dynamics Algorithms (2008), 2.4; XN, XS, XT of Abaqus.
void set_line_point(const ContactTotal& total, const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
                    double* values) {
  const double square = force.squaredNorm();
  if (!(square > 0.0)) return set(Eigen::Vector3d::Zero(), values);
  const Eigen::Vector3d foot = force.cross(moment) / square;  // nearest to the origin
  const Eigen::Vector3d centre = total.normal_sum > 0.0 ? centre_of(total) : foot;
  set(foot + force.dot(centre - foot) / square * force, values);
}

void set_centre(const ContactTotal& total, double* values) {
  const bool touches = total.normal_sum > 0.0;
  set(touches ? centre_of(total) : Eigen::Vector3d::Zero(), values);
}

/// Along the friction force on the node, and across it, by the right hand about the normal force.
void set_slip_components(const NodeContact& node, double* values) {
  const Eigen::Vector3d along = node.tangential.normalized();  // 0 of 0
  values[0] = node.slip_velocity.dot(along);
  values[1] = node.slip_velocity.dot(node.normal.normalized().cross(along));
}

double per_area(double value, double area) { return area > 0.0 ? value / area : 0.0; }

}  // namespace

std::span<const ContactNodeRow> contact_node_rows() {
  using N = const NodeContact&;
  constexpr auto scalar = FieldShape::scalar, vector = FieldShape::vector;
  static constexpr std::array rows{
      ContactNodeRow{"contact_status", scalar, [](N n, double* v) { *v = n.status; },
                     "1 touches, 0.5 of a block or surface in contact, 0 of none [1]"},
      ContactNodeRow{"contact_normal_direction", vector, [](N n, double* v) { set_direction(n.normal, v); },
                     "Direction of the normal force on the node [1]"},
      ContactNodeRow{"contact_tangential_direction", vector,
                     [](N n, double* v) { set_direction(n.tangential, v); },
                     "Direction of the friction force on the node [1]"},
      ContactNodeRow{"contact_normal_traction_magnitude", scalar,
                     [](N n, double* v) { *v = per_area(n.normal.norm(), n.area); },
                     "Normal force over the area that touches [force/length^2]"},
      ContactNodeRow{"contact_tangential_traction_magnitude", scalar,
                     [](N n, double* v) { *v = per_area(n.tangential.norm(), n.area); },
                     "Friction force over the area that touches [force/length^2]"},
      ContactNodeRow{"contact_normal_force", vector, [](N n, double* v) { set(n.normal, v); },
                     "Along normals, of both sides of a shell together [force]"},
      ContactNodeRow{"contact_tangential_force", vector, [](N n, double* v) { set(n.tangential, v); },
                     "Of friction, the same [force]"},
      ContactNodeRow{"contact_normal_force_magnitude", scalar, [](N n, double* v) { *v = n.normal.norm(); },
                     "[force]"},
      ContactNodeRow{"contact_tangential_force_magnitude", scalar,
                     [](N n, double* v) { *v = n.tangential.norm(); }, "[force]"},
      ContactNodeRow{"contact_normal_gap", scalar, [](N n, double* v) { *v = n.gap; },
                     "To the nearest face of the other side, < 0 where it touches; with none within TRACKING "
                     "DISTANCE, or a share of the face, that distance [length]",
                     true},
      ContactNodeRow{"contact_tangential_gap", scalar, [](N n, double* v) { *v = n.tangential_gap; },
                     "Slip that is not lost: what the tangential spring holds [length]"},
      ContactNodeRow{"contact_accumulated_slip", scalar, [](N n, double* v) { *v = n.friction.slip_length; },
                     "Length of the path slipped under friction since the start [length]"},
      ContactNodeRow{"contact_accumulated_slip_vector", vector,
                     [](N n, double* v) { set(n.friction.slip, v); },
                     "Sum of the steps of that path as vectors that turn with the surface [length]"},
      ContactNodeRow{"contact_incremental_slip_magnitude", scalar,
                     [](N n, double* v) { *v = n.friction.last_slip.norm(); }, "Of the last step [length]"},
      ContactNodeRow{"contact_incremental_slip_direction", vector,
                     [](N n, double* v) { set_direction(n.friction.last_slip, v); }, "Of the last step [1]"},
      ContactNodeRow{"contact_slip_rate", scalar, [](N n, double* v) { *v = n.slip_rate; },
                     "Slip over the last step [length/time]"},
      ContactNodeRow{"contact_slip_rate_vector", vector, [](N n, double* v) { set(n.slip_velocity, v); },
                     "The same with its direction [length/time]"},
      ContactNodeRow{"contact_slip_rate_components", FieldShape::list, set_slip_components,
                     "Of that along contact_tangential_direction, < 0 where friction brakes, and across it "
                     "[length/time]",
                     false, 2},
      ContactNodeRow{"contact_frictional_energy", scalar, [](N n, double* v) { *v = n.friction.energy; },
                     "The node's share of what friction has taken since the start [energy]"},
      ContactNodeRow{"contact_frictional_energy_density", scalar,
                     [](N n, double* v) { *v = per_area(n.friction.energy, n.surface_area); },
                     "The same over the node's share of its surface at the start [energy/length^2]"},
      ContactNodeRow{"contact_area", scalar, [](N n, double* v) { *v = n.area; },
                     "Area that touches, the node's share [length^2]"},
      ContactNodeRow{"contact_interaction", scalar, [](N n, double* v) { *v = n.interaction; },
                     "Number of the pair in the log's table, the last of several; 0 of none [1]"},
      ContactNodeRow{"contact_slip_status", scalar, [](N n, double* v) { *v = n.slip_status; },
                     "2 slips, 1 is held along the surface by friction or a tie, 0 neither [1]"},
  };
  return rows;
}

std::span<const ContactTotalRow> contact_total_rows() {
  using T = const ContactTotal&;
  constexpr auto scalar = FieldShape::scalar, vector = FieldShape::vector;
  static constexpr std::array rows{
      ContactTotalRow{"contact_force", vector, [](T t, double* v) { set(t.force(), v); },
                      "On the surface, or on the first of two [force]"},
      ContactTotalRow{"contact_normal_force", vector, [](T t, double* v) { set(t.normal_force, v); },
                      "Of that what acts along normals [force]"},
      ContactTotalRow{"contact_friction_force", vector, [](T t, double* v) { set(t.friction_force, v); },
                      "Of that what acts along the surface [force]"},
      ContactTotalRow{"contact_moment", vector, [](T t, double* v) { set(t.moment(), v); },
                      "Of the force about the origin [force length]"},
      ContactTotalRow{"contact_normal_moment", vector, [](T t, double* v) { set(t.normal_moment, v); },
                      "Of the normal force about the origin [force length]"},
      ContactTotalRow{"contact_friction_moment", vector, [](T t, double* v) { set(t.friction_moment, v); },
                      "Of the friction force about the origin [force length]"},
      ContactTotalRow{
          "contact_line_point", vector, [](T t, double* v) { set_line_point(t, t.force(), t.moment(), v); },
          "Point of the line of action of the force nearest to the centre, 0 without any [length]"},
      ContactTotalRow{"contact_normal_line_point", vector,
                      [](T t, double* v) { set_line_point(t, t.normal_force, t.normal_moment, v); },
                      "The same of the normal force [length]"},
      ContactTotalRow{"contact_friction_line_point", vector,
                      [](T t, double* v) { set_line_point(t, t.friction_force, t.friction_moment, v); },
                      "The same of the friction force [length]"},
      ContactTotalRow{"contact_centre", vector, set_centre,
                      "Mean place by normal force, 0 without any [length]"},
      ContactTotalRow{"contact_area", scalar, [](T t, double* v) { *v = t.area; }, "That touches [length^2]"},
      ContactTotalRow{"contact_penetration_max", scalar, [](T t, double* v) { *v = t.penetration; },
                      "Deepest penetration of what has touched since the start [length]", true},
      ContactTotalRow{"contact_energy", scalar, [](T t, double* v) { *v = t.energy; },
                      "Taken from the bodies since the start, < 0 given to them [energy]", true},
      ContactTotalRow{"friction_energy", scalar, [](T t, double* v) { *v = t.friction; },
                      "Lost to friction since the start [energy]", true},
  };
  return rows;
}

}  // namespace contactsim
