// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_kinematics.hpp"
#include "core/base/prefetch.hpp"

namespace contactsim {

/// Fetches where a node is, and its velocity.
[[gnu::always_inline]] inline void prefetch(const ContactKinematics& kinematics, ContactNodeIndex node) {
  __builtin_prefetch(kinematics.x(node).data());
  __builtin_prefetch(kinematics.v(node).data());
}

}  // namespace contactsim
