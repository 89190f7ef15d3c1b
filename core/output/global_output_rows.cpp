// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <array>

#include "core/output/output_table.hpp"

namespace contactsim {

namespace {

using Values = std::span<double>;

constexpr OutputRow always(OutputRow row) {
  row.is_always_written = true;
  return row;
}

constexpr OutputRow from_all(OutputRow row) {
  row.reads_all = true;
  return row;
}

// A row that copies one of the energies.
template <double Energies::*energy>
constexpr OutputRow energy_row(std::string_view name, std::string_view help) {
  return {name,
          FieldLocation::global,
          FieldShape::scalar,
          false,
          [](const OutputContext& context, const EntityRange&, Values values) {
            values[0] = context.state.energies.*energy;
          },
          help};
}

void fill_strain_energy(const OutputContext& context, const EntityRange&, Values values) {
  double sum = 0.0;
  for (std::size_t b = 0; b < context.model.blocks.size(); ++b) {
    const ModelBlock& block = context.model.blocks[b];
    for (std::size_t e = 0; e < block.n_elements; ++e)
      sum += context.state.blocks[b].at(block.layout, e, block.layout.energy());
  }
  values[0] = sum;
}

void fill_dead_elements(const OutputContext& context, const EntityRange&, Values values) {
  std::size_t n_dead = 0;
  for (std::size_t b = 0; b < context.model.blocks.size(); ++b) {
    if (context.state.blocks[b].life.empty()) continue;  // nothing here can die
    for (std::size_t e = 0; e < context.model.blocks[b].n_elements; ++e)
      n_dead += context.state.blocks[b].life_of(e) == 0.0 ? 1 : 0;
  }
  values[0] = static_cast<double>(n_dead);
}

void fill_momentum(const OutputContext& context, const EntityRange&, Values values) {
  for (std::size_t i = 0; i < 3; ++i) values[i] = context.state.momentum[static_cast<Eigen::Index>(i)];
}

void fill_angular_momentum(const OutputContext& context, const EntityRange&, Values values) {
  const RigidBodies& rigid = context.model.rigid;
  const Eigen::RowVectorXd& mass = rigid.empty() ? context.model.mass : rigid.free_mass;
  const Eigen::RowVectorXd& inertia = rigid.empty() ? context.model.inertia : rigid.free_inertia;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index n = 0; n < context.state.coordinates.cols(); ++n) {
    const Eigen::Vector3d x = context.state.coordinates.col(n), v = context.state.velocity.col(n);
    sum += mass(n) * x.cross(v);
  }
  const Eigen::Matrix3Xd& turning = context.state.rotations.velocity;
  for (Eigen::Index n = 0; n < turning.cols(); ++n) sum += inertia(n) * turning.col(n);
  for (std::size_t i = 0; i < context.state.rigid.size(); ++i) {
    const RigidBodyState& body = context.state.rigid[i];
    sum += body.now.spin + rigid.bodies[i].mass * body.position.cross(body.now.velocity);
  }
  for (std::size_t i = 0; i < 3; ++i) values[i] = sum[static_cast<Eigen::Index>(i)];
}

}  // namespace

std::span<const OutputRow> global_output_rows() {
  using L = FieldLocation;
  using S = FieldShape;
  static constexpr std::array rows{
      OutputRow{"time", L::global, S::scalar, false,
                [](const OutputContext& context, const EntityRange&, Values v) { v[0] = context.state.time; },
                "Time [time]"},
      OutputRow{"timestep", L::global, S::scalar, false,
                [](const OutputContext& context, const EntityRange&, Values v) {
                  v[0] = context.state.dt > 0.0 ? context.state.dt : context.state.next_dt;
                },
                "Size of the step that ended; at the start of the one to come [time]"},
      OutputRow{"step", L::global, S::scalar, false,
                [](const OutputContext& context, const EntityRange&, Values v) {
                  v[0] = static_cast<double>(context.state.step);
                },
                "Number of steps so far [1]"},
      always(energy_row<&Energies::kinetic>("kinetic_energy", "Kinetic energy [energy]")),
      always(energy_row<&Energies::internal>(
          "internal_energy",
          "Work of all internal forces, hourglass and bulk viscosity included; "
          "summed with kinetic_energy it is "
          "what the steps conserve [energy]")),
      always(energy_row<&Energies::external>("external_energy",
                                             "Work of loads, gravity and prescribed motion [energy]")),
      always(energy_row<&Energies::hourglass>("hourglass_energy", "Part of internal_energy [energy]")),
      always(
          energy_row<&Energies::bulk_viscosity>("bulk_viscosity_energy", "Part of internal_energy [energy]")),
      always(energy_row<&Energies::contact>(
          "contact_energy",
          "Taken up by contact forces; friction, contact damping and impact included [energy]")),
      energy_row<&Energies::friction>("friction_energy", "Part of contact_energy, lost to friction [energy]"),
      energy_row<&Energies::contact_damping>("contact_damping_energy",
                                             "Part of contact_energy, lost to contact damping [energy]"),
      energy_row<&Energies::impact>("contact_impact_energy",
                                    "Part of contact_energy, lost where sides met without rebound [energy]"),
      energy_row<&Energies::stabilization>(
          "contact_stabilization_energy",
          "Part of contact_energy, lost to CONTACT STABILIZATION of load steps [energy]"),
      always(energy_row<&Energies::error>(
          "energy_error", "Energy that appeared from nowhere: what the balance lacks [energy]")),
      from_all(OutputRow{
          "strain_energy", L::global, S::scalar, false, fill_strain_energy,
          "Work of the materials' stresses, plastic work included; internal_energy without hourglass "
          "and bulk viscosity [energy]"}),
      always(OutputRow{"momentum", L::global, S::vector, false, fill_momentum,
                       "Linear momentum [mass length/time]"}),
      from_all(OutputRow{"angular_momentum", L::global, S::vector, false, fill_angular_momentum,
                         "Angular momentum about the origin [mass length^2/time]"}),
      from_all(OutputRow{"dead_elements", L::global, S::scalar, false, fill_dead_elements,
                         "Number of elements that have died so far [1]"}),
  };
  return rows;
}

}  // namespace contactsim
