// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "core/elements/shell/membrane_surface.hpp"
#include "core/elements/shell/quad_shell.hpp"
#include "core/elements/shell/shell_batches.hpp"
#include "core/elements/shell/triangle_shell.hpp"

namespace contactsim {

const ElementFormulation shell4_membrane =
    shell_element<MembraneSurface<QuadShell>>(Shape::shell4, "mean_quadrature");
const ElementFormulation quad4_membrane =
    shell_element<MembraneSurface<QuadShell>>(Shape::quad4, "mean_quadrature");
const ElementFormulation shell3_membrane =
    shell_element<MembraneSurface<TriangleShell>>(Shape::shell3, "mean_quadrature");

}  // namespace contactsim
