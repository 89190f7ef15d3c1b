// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_batches.hpp"
#include "core/elements/elements.hpp"
#include "core/elements/solid/hex_geometry.hpp"
#include "core/elements/solid/uniform_gradient.hpp"

namespace contactsim {

const ElementFormulation hex8_mean_quadrature = solid_element<UniformGradient<Shape::hex8, HexGeometry>>();

}  // namespace contactsim
