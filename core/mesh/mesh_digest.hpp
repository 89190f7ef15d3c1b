// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A fingerprint of where the nodes of a mesh are and which elements they have: two meshes with the same one
/// are the same for a run.
std::uint64_t digest_of(const Mesh& mesh);

}  // namespace contactsim
