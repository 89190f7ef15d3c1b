// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "contact/formulations/contact_step_context.hpp"

namespace contactsim {

/// When narrow phases look at all candidates of a search, and when at those alone that are close: as long as
/// no contact node has moved farther, or sides close faster, than the close ones were found for. It never
/// changes what is found.
class CloseWindow {
 public:
  /// Other candidates have been found.
  void forget() { *this = {}; }
  /// Says of the narrow phase of a context which candidates it looks at.
  ///   context  its `candidates` and `close_range` are set
  void choose(ContactStepContext& context);
  /// Takes notice of how many candidates a choice of renew_close has found to be close. Returns whether that
  /// is worth the while; all are looked at until the next search if not.
  bool note(std::size_t n_close, std::size_t n_candidates);

 private:
  double mean_radius_ = 0.0;  // of faces with candidates, 0 before it is known [length]
  bool are_known_ = false;    // the close ones
  bool are_few_ = true;
  CloseRange range_;
  double path_ = 0.0;  // of the contact nodes as they were found [length]
};

}  // namespace contactsim
