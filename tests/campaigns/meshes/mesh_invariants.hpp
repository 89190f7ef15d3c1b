// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/mesh/mesh.hpp"

namespace contactsim::test {

/// What of a mesh that was read refers to something that is not there, one after the other by loops; "" when
/// nothing does: nodes of elements and node sets, elements and sides of side sets, members of assemblies; ids
/// and names that stand twice; coordinates that are no numbers; lists of the wrong length.
std::string find_broken_reference(const Mesh& mesh);

}  // namespace contactsim::test
