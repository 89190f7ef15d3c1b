// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/mesh.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

/// The lines of a BEGIN CONTACT DEFINITION block as definition; places are in the file "c.i", lines from 1.
/// This and the next two throw std::logic_error with the parser's messages when it has any.
ContactDefinition parse_contact(const std::string& lines);
/// The lines of a region.
Region parse_region(const std::string& lines);
/// The lines of a deck outside procedures: sections, finite element models.
SimulationDefinition parse_definitions(const std::string& lines);

/// What resolving made, and the errors that it reported, in machine form.
struct Resolved : ContactSurfaces {
  std::string messages;

  /// The surface with that very name. Throws std::logic_error when there is none.
  const ContactSurface& operator[](const std::string& name) const;
};

/// Resolves the surfaces of contact definition lines on a mesh, and then lets elements die.
///   alive  [n_elements] 0 of those, or empty when all live
Resolved resolve(const Mesh& mesh, const std::string& lines, std::span<const std::uint8_t> alive = {});
/// The same of a region, whose analytic objects may be used, with aliases.
Resolved resolve(const Mesh& mesh, const Region& region, std::span<const MeshAlias> aliases = {});

/// What making a contact model gave, and the errors that it reported, in machine form.
struct Modelled : ContactModel {
  std::string messages;
};

/// Makes the contact model of contact definition lines, under definitions (sections, finite element models).
///   alive  [n_elements] 0 of elements that die then, or empty when all live
Modelled make_model(const Mesh& mesh, const std::string& contact_lines, const std::string& definitions = "",
                    std::span<const std::uint8_t> alive = {});
/// The same of a region, whose analytic objects may be used.
Modelled make_model(const Mesh& mesh, const Region& region, const std::string& definitions = "",
                    std::span<const std::uint8_t> alive = {});

/// [n_elements] 1, but 0 for the elements of the ids.
std::vector<std::uint8_t> all_but(const Mesh& mesh, const std::vector<std::int64_t>& dead_ids);

/// The faces of a surface as "1:4 1:6 3:2", element id and side, in stored order.
std::string list_faces(const Mesh& mesh, const ContactSurface& surface);
/// The ids of its lofted elements, and of its nodes.
std::string list_lofted(const Mesh& mesh, const ContactSurface& surface);
std::string list_nodes(const Mesh& mesh, const ContactSurface& surface);

/// What a surface lost, as "surfB 4 faces, block_2 1 lofted", in stored order.
std::string list_lost(const ContactSurfaces& result, const ContactSurface& surface);
/// All surfaces with what they own and lost, one a line: "name | faces | lofted | nodes | lost". Two results
/// with equal texts are the same to contact.
std::string describe(const Mesh& mesh, const ContactSurfaces& result);
/// The warnings, one a line: "surface-empty, line 2, surf_1, 0: text".
std::string list_warnings(const ContactSurfaces& result);
/// All of it: surfaces, warnings, faces ignored.
std::string describe_all(const Mesh& mesh, const ContactSurfaces& result);

/// Every face, interior ones included, that satisfies the condition, in order of element and side.
std::vector<ElementSide> faces_where(MeshBuilder builder, const SideCondition& condition);

}  // namespace contactsim::test
