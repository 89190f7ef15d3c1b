// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/definition/declarations.hpp"

namespace contactsim {

/// The heading of a procedure of a deck with several: its name, kind, region and times, and what its state is
/// taken over from.
///   before  null: it is the first
std::string format_procedure(const Procedure& procedure, const Region& region, const Procedure* before);

}  // namespace contactsim
