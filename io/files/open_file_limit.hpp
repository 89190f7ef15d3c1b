// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace contactsim {

/// Has the system let this process open so many files at once beside those that it needs anyway, as far as it
/// may: what cannot be opened then is an error of its own.
void allow_open_files(std::size_t n);

}  // namespace contactsim
