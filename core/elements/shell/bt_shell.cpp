// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "core/elements/shell/quad_shell.hpp"
#include "core/elements/shell/shell_batches.hpp"

namespace contactsim {

const ElementFormulation shell4_bt_shell = shell_element<QuadShell>(Shape::shell4, "bt_shell");
const ElementFormulation quad4_bt_shell = shell_element<QuadShell>(Shape::quad4, "bt_shell");

}  // namespace contactsim
