// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/base/diagnostics.hpp"
#include "core/definition/finite_element_model.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A copy of a mesh without some of its blocks: their elements are gone, with the nodes that no other element
/// has, from side sets, node sets and assemblies too. What is left keeps its order and its ids.
/// Precondition: the mesh has the order of its file.
///   blocks  positions
Mesh without_blocks(const Mesh& mesh, std::span<const std::uint32_t> blocks);

/// The mesh without what OMIT BLOCK and OMIT ASSEMBLY name. Errors: an unknown name, nothing left.
/// Source: Sierra/SM 5.22, FINITE ELEMENT MODEL.
Mesh omit_blocks(const FiniteElementModel& model, Mesh mesh, Diagnostics& diagnostics);

}  // namespace contactsim
