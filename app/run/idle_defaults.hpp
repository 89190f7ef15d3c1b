// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// A line of INTERACTION DEFAULTS that acts on some pairs is not reported for the others: the first of the
/// pairs that have it, if it acts on none; else null.
template <class Has, class Acts>
const SurfacePair* find_idle_default(const ContactModel& contact, const Has& has, const Acts& acts) {
  const SurfacePair* first = nullptr;
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!pair.is_from_defaults || !has(pair)) continue;
    if (acts(i)) return nullptr;
    if (first == nullptr) first = &pair;
  }
  return first;
}

}  // namespace contactsim
