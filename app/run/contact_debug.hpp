// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "contact/enforcement/contact_force.hpp"
#include "core/definition/declarations.hpp"

namespace contactsim {

/// The files that BEGIN DEBUG of a contact definition asks for. Source: Sierra/SM 5.22, 8.10.1.
struct ContactDebugFiles {
  std::string facets;  ///< of the contact facets as a mesh of their own, "" for none
  std::string places;  ///< CSV of the contact points at the end of the run, "" for none

  std::vector<std::string> paths() const;
};

/// Named after the deck: %B_contact_facets.exo, %B_contact_places.csv.
ContactDebugFiles contact_debug_files(const SimulationDefinition& definition, const ContactDebug& debug);

/// The contact points of a state that the contact force has seen last: pair, faces or node by their ids,
/// gap, area, normal and tangential force.
std::string format_places_csv(const ContactForce& force, const ContactModel& contact, const Mesh& mesh);

}  // namespace contactsim
