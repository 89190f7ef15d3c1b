// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/base/diagnostics.hpp"
#include "core/base/names.hpp"
#include "core/mesh/mesh.hpp"

/// What contact cannot take of the mesh parts that a deck names.
namespace contactsim {

/// Reports a block of particles where the command cannot take one; returns whether the entity may be used.
///   name  of the entity in the deck
bool check_not_particles(const Mesh& mesh, const Entity& entity, const DeckName& name,
                         std::string_view command, Diagnostics& diagnostics);

/// Reports a side set that holds edges or nodes; returns whether all its sides are faces.
///   item  its name in the deck
bool check_faces(const Mesh& mesh, std::uint32_t side_set, const DeckName& item, Diagnostics& diagnostics);

/// Throws FileError for a block with elements of a type that is not known.
///   location  of the command that puts it into contact
void check_shape(const Mesh& mesh, std::uint32_t block, const DeckLocation& location);

}  // namespace contactsim
