// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/index.hpp"

/// Positions in the lists of contact, in core because several of its rooms share them that do not know each
/// other.
namespace contactsim {

/// Position of a pair of surfaces in ContactModel::pairs.
using PairIndex = Index<struct SurfacePairKind>;
/// Position of a contact surface in ContactSurfaces::surfaces.
using SurfaceIndex = Index<struct ContactSurfaceKind>;
/// Position of a node among those of contact, see ContactMesh::nodes().
using ContactNodeIndex = Index<struct ContactNodeKind>;
/// Position of a face in ContactMesh::faces.
using FaceIndex = Index<struct ContactFaceKind>;
/// Position of a node of a surface in ContactMesh::surface_nodes, its row.
using SurfaceNodeIndex = Index<struct SurfaceNodeKind>;
/// Position of an edge in ContactMesh::edges.
using EdgeIndex = Index<struct ContactEdgeKind>;

}  // namespace contactsim
