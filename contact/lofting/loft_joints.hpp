// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/lofting/loft.hpp"

namespace contactsim {

/// Closes the wedges between bricks. Where shells meet so sharply that they keep their own normals, their
/// bricks overlap on the inside of the fold and leave a wedge open on its outside. A joint spans it: a flat
/// facet from one brick's skin to the next one's, and triangles that close the ends of joints, at the border
/// of the shells and where three or more meet in a corner. Joints belong to the first of their shells.
///   coordinates  3 x n_nodes [length]
///   loft         has all bricks; gets the joints, after all other facets, by element and nodes
void add_joints(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates, LoftGeometry& loft);

}  // namespace contactsim
