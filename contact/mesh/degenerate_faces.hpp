// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/mesh/contact_mesh.hpp"

namespace contactsim {

/// The elements with a contact face that has lost its shape: a corner is turned over, or flat to a hundredth
/// of a right one of the face's size. Ascending, each once.
///   coordinates  3 x n_nodes of the mesh, now [length]
std::vector<ElementIndex> find_degenerate_faces(const ContactMesh& contact_mesh,
                                                const Eigen::Matrix3Xd& coordinates);

}  // namespace contactsim
