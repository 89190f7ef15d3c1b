// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace contactsim {

// Lengths of texts that the Exodus library expects [characters]. Source: exodusII.h, MAX_LINE_LENGTH and
// MAX_STR_LENGTH, with room for the final NUL.
inline constexpr std::size_t exodus_title_length = 80, exodus_string_length = 33, exodus_line_length = 81;

/// Whether ids are 1, 2, 3 ..., which files leave out. Every id is looked at: that goes by vectors.
template <class Id>
bool is_counting(std::span<const Id> ids) {
  std::uint64_t differs = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) differs |= static_cast<std::uint64_t>(ids[i]) ^ (i + 1);
  return differs == 0;
}

}  // namespace contactsim
