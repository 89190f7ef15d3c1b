// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/element_table.hpp"

/// The rows of the element table, one per file.
namespace contactsim {

extern const SolidElement hex8_mean_quadrature;
extern const SolidElement hex8_selective_deviatoric;
extern const SolidElement hex8_fully_integrated;
extern const SolidElement tet4_mean_quadrature;
extern const SolidElement wedge6_mean_quadrature;
extern const SolidElement pyramid5_mean_quadrature;

extern const SolidElement beam2_beam;
extern const SolidElement bar2_beam;
extern const SolidElement beam2_truss;
extern const SolidElement bar2_truss;
extern const SolidElement sphere_particle;

extern const SolidElement beam2_spring;
extern const SolidElement bar2_spring;
extern const SolidElement beam2_damper;
extern const SolidElement bar2_damper;
extern const SolidElement sphere_point_mass;
extern const SolidElement sphere_point_inertia;

extern const SolidElement shell4_bt_shell;
extern const SolidElement quad4_bt_shell;
extern const SolidElement shell3_c0_tri_shell;

extern const SolidElement shell4_membrane;
extern const SolidElement quad4_membrane;
extern const SolidElement shell3_membrane;

}  // namespace contactsim
