// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/enforcement/contact_assembler.hpp"
#include "contact/formulations/face_face/weighted_gaps.hpp"
#include "contact/formulations/interface_constraint.hpp"
#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_mesh.hpp"
#include "core/base/saved_state.hpp"

namespace contactsim {

/// The faces of contact between two load steps and all that it remembers of them.
struct ContactCheckpoint {
  ContactMesh contact_mesh;
  std::vector<double> element_stiffness;  ///< as limit_stiffness() has it [force/length^3]
  WeightedGaps weighted_gaps;
  // Of the last step.
  ContactAssembler assembler;
  std::vector<ContactPoint> points;
  std::vector<ConstraintForces> constraint_forces;
  SavedState memory;  ///< of ContactForce::archive(), with numbers of its own
};

}  // namespace contactsim
