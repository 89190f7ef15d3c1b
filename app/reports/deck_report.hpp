// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// What a deck defines, by number.
std::string format_definition(const SimulationDefinition& definition);

/// What a mesh holds, by number, and its blocks.
std::string format_mesh(const Mesh& mesh);

}  // namespace contactsim
