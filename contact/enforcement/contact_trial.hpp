// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/enforcement/offset_moments.hpp"
#include "contact/formulations/contact_multipliers.hpp"
#include "contact/formulations/slip_pressures.hpp"

namespace contactsim {

/// What contact finds in the trials of a load step, apart from all that it remembers.
struct ContactTrial {
  ContactTrial(const ContactMesh& contact_mesh, const ContactKinematics& kinematics, std::size_t n_pairs,
               bool has_moments)
      : assembler(contact_mesh.n_nodes(), n_pairs, false, has_moments),
        moments(contact_mesh, kinematics, assembler) {}

  ContactAssembler assembler;
  OffsetMoments moments;
  std::vector<ContactPoint> points;           // of the last trial
  std::vector<ConstraintForces> constraints;  // of the last trial
  // Of the start of the step.
  Eigen::Matrix3Xd offsets;  // of the points of lofts [length]
  ContactMultipliers multipliers;
  double dt = 0.0;               // of the step [time]
  SlipPressures slip_pressures;  // of the trial whose limits are held; empty: none are
};

}  // namespace contactsim
