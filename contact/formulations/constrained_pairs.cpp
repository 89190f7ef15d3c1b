// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/constrained_pairs.hpp"

namespace contactsim {

void ConstrainedPairs::archive(StateArchive& saved) {
  faces_.archive("contact/glued_faces", saved);
  nodes_.archive("contact/glued_nodes", saved);
}

void ConstrainedPairs::remap(const ContactRemap& remap) {
  faces_.remap(remap.faces, remap.faces);
  nodes_.remap(remap.rows, Unchanged{});
}

}  // namespace contactsim
