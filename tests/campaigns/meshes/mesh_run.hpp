// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/mesh.hpp"

namespace contactsim::test {

/// A run of a mesh whose blocks may touch each other: a deck that gives every block a material and a section,
/// the model of contact with its gaps and overlaps, the start and a step. Throws DeckError, FileError and
/// SolveError for what cannot be.
void run_mesh(const Mesh& mesh);

}  // namespace contactsim::test
