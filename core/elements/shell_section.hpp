// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/finite_element_model.hpp"
#include "core/definition/section.hpp"
#include "core/elements/shell_settings.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Membranes as shells of one layer in their middle, about which the nodes are.
ShellSection as_shell_section(const MembraneSection& section);

/// What a SHELL SECTION and the parameters of a block say of its shells. Nothing when an error was added: a
/// rule of integration that does not exist or does not have so many points. Lines that have no effect are
/// warned of.
///   location  of the section
std::optional<ShellSettings> make_shell_settings(const ShellSection& section,
                                                 const BlockParameters& parameters,
                                                 const DeckLocation& location, Diagnostics& diagnostics);

/// The thickness of every element of a block: the section's, else the mesh's attribute, times the scale
/// factor [length]. Nothing when an error was added: there is none, or one is not positive.
///   block     position in the mesh
///   location  of the section, or of what has none
std::optional<std::vector<double>> find_thicknesses(const ShellSection& section, const Mesh& mesh,
                                                    std::uint32_t block, const DeckLocation& location,
                                                    Diagnostics& diagnostics);

}  // namespace contactsim
