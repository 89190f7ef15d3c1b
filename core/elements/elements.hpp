// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_table.hpp"

/// The rows of the element table, one per file.
namespace contactsim {

extern const ElementFormulation hex8_mean_quadrature;
extern const ElementFormulation hex8_selective_deviatoric;
extern const ElementFormulation hex8_fully_integrated;
extern const ElementFormulation tet4_mean_quadrature;
extern const ElementFormulation tet10_composite;
extern const ElementFormulation wedge6_mean_quadrature;
extern const ElementFormulation pyramid5_mean_quadrature;

extern const ElementFormulation beam2_beam;
extern const ElementFormulation bar2_beam;
extern const ElementFormulation beam2_truss;
extern const ElementFormulation bar2_truss;
extern const ElementFormulation sphere_particle;

extern const ElementFormulation beam2_spring;
extern const ElementFormulation bar2_spring;
extern const ElementFormulation beam2_damper;
extern const ElementFormulation bar2_damper;
extern const ElementFormulation sphere_point_mass;
extern const ElementFormulation sphere_point_inertia;

extern const ElementFormulation shell4_bt_shell;
extern const ElementFormulation quad4_bt_shell;
extern const ElementFormulation shell3_c0_tri_shell;

extern const ElementFormulation shell4_membrane;
extern const ElementFormulation quad4_membrane;
extern const ElementFormulation shell3_membrane;

}  // namespace contactsim
