// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "io/import/draft_mesh.hpp"

namespace contactsim {

/// A mesh and what became of groups, in words for the user.
struct MadeMesh {
  Mesh mesh;
  std::vector<std::string> notes;  ///< a line for each group, "surface 'target': side set 30, 16 sides"
};

/// Makes a mesh of a draft. A group of solids is a block, of several shapes several blocks. A group of
/// surfaces that lie on solids is a side set, else a block of shells. A group of lines or points whose nodes
/// belong to solids or shells is a node set, else a block of beams or spheres. Nodes that nothing has are
/// left out. Names and ids stay where they are free. Throws FileError for a group that is neither as a whole,
/// and for faces that no solid has.
MadeMesh make_mesh(const DraftMesh& draft);

}  // namespace contactsim
