// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/surfaces/skin_faces.hpp"
#include "contact/surfaces/surface_request.hpp"

namespace contactsim {

/// What a request claims, whoever owns it: skin faces of its blocks and faces of its side sets, less the
/// faces of removed side sets. Positions in SkinFaces::faces, ascending, each once.
std::vector<std::uint32_t> claimed_faces(const SurfaceRequest& request, const Mesh& mesh,
                                         const SkinFaces& skin_faces);

/// Lofted elements of its blocks and its single elements, less the shells of removed side sets. Positions in
/// SkinFaces::lofted, ascending, each once.
std::vector<std::uint32_t> claimed_lofted(const SurfaceRequest& request, const Mesh& mesh,
                                          const SkinFaces& skin_faces);

/// Nodes of a surface of nodes: of node sets as they are, of living sides (their corners) and of living
/// elements. Ascending, each once.
std::vector<NodeIndex> claimed_nodes(const SurfaceRequest& request, const Mesh& mesh,
                                     const ContactDomain& domain);

}  // namespace contactsim
