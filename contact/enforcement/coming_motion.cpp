// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/coming_motion.hpp"

#include "core/base/threads.hpp"
#include "core/elements/force_term.hpp"

namespace contactsim {

void ComingMotion::foresee(const State& state, const ContactMesh& contact_mesh,
                           ContactKinematics& kinematics) {
  const double half_steps = 0.5 * (state.dt + state.next_dt);
  const bool turns = state.rotations.exist();
  velocity_.resize(3, state.velocity.cols());
  if (turns) turning_.resize(3, state.velocity.cols());
  const auto n_nodes = static_cast<std::uint32_t>(contact_mesh.n_nodes());
  parallel_for(n_nodes, threads_for(contact_mesh.n_mesh_points()), [&](std::uint32_t i) {
    const auto node = static_cast<Eigen::Index>(contact_mesh.mesh_nodes[{i}].value);
    velocity_.col(node) = state.velocity.col(node) + half_steps * state.acceleration.col(node);
    if (!turns) return;
    turning_.col(node) =
        state.rotations.velocity.col(node) + half_steps * state.rotations.acceleration.col(node);
  });
  Motion coming{state.time, state.dt, state.coordinates, velocity_};
  if (turns) coming.angular_velocity = &turning_;
  kinematics.foresee(coming);
  kinematics.bound_watched();
}

}  // namespace contactsim
