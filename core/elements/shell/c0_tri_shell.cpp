// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "core/elements/shell/shell_batches.hpp"
#include "core/elements/shell/triangle_shell.hpp"

namespace contactsim {

const ElementFormulation shell3_c0_tri_shell = shell_element<TriangleShell>(Shape::shell3, "c0_tri_shell");

}  // namespace contactsim
