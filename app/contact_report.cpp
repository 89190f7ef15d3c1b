// SPDX-License-Identifier: BSD-3-Clause
#include "app/contact_report.hpp"

#include <fmt/format.h>

#include "app/counted.hpp"

namespace contactsim {

std::string format_contact(const ContactForce& contact) {
  const ContactSearch& search = contact.search();
  const BroadPhaseCounts &faces = search.face_counts(), &nodes = search.node_counts();
  std::string text = "\nContact search\n";
  text +=
      fmt::format("  {}, {}, {}\n", counted(contact.faces().faces.size(), "contact face"),
                  counted(contact.faces().n_nodes(), "contact node"), counted(contact.ties().size(), "tie"));
  text += fmt::format("  {}: trees built {} and refitted {} times, {:.6g} candidates in all, {} at the end\n",
                      counted(search.n_searches(), "global search", "global searches"),
                      faces.builds + nodes.builds, faces.refits + nodes.refits,
                      static_cast<double>(faces.candidates + nodes.candidates), contact.n_candidates());
  text += fmt::format("  contact lowers the stable time step by {:.3g} % at most",
                      100.0 * contact.step_share().share);
  return text + "\n";
}

}  // namespace contactsim
