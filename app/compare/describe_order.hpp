// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace contactsim {

/// How one order of things becomes another, in a line: what changes places, goes elsewhere together, is
/// reversed, or which things go and where to, as few as can be. Short lists are given as they are.
///   names   in the first order
///   places  [names.size()] in the second, from 0: a permutation that moves something
std::string describe_order(const std::vector<std::string>& names, const std::vector<std::size_t>& places);

}  // namespace contactsim
