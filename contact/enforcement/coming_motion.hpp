// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_kinematics.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// How contact nodes move in the coming step, as the forces so far give it.
class ComingMotion {
 public:
  /// Has the contact nodes move so.
  void foresee(const State& state, const ContactMesh& contact_mesh, ContactKinematics& kinematics);

 private:
  Eigen::Matrix3Xd velocity_, turning_;  // of nodes of the mesh that contact nodes hang on
};

}  // namespace contactsim
