// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include "core/base/names.hpp"

namespace contactsim {

/// BEGIN SOLID SECTION: hexahedra, tetrahedra, wedges. The default of a block without a section.
struct SolidSection {
  DeckName formulation{"mean_quadrature", {}};
  DeckName strain_incrementation{"midpoint_increment", {}};
  std::optional<double> deviatoric_parameter;  ///< share of deviatoric full integration, 0 to 1 [1]
  bool is_hourglass_total = false;             ///< HOURGLASS FORMULATION = TOTAL, else INCREMENTAL
  bool is_hourglass_rotation_scaled = false;   ///< HOURGLASS ROTATION = SCALED, else APPROXIMATE
};

/// BEGIN TOTAL LAGRANGE SECTION.
struct TotalLagrangeSection {
  DeckName formulation{"composite_tet", {}};
  bool has_volume_average_j = false;
  std::optional<double> vem_exponent;  ///< [1]
};

/// BEGIN COHESIVE SECTION: hexahedra and wedges between two surfaces, with or without a thickness.
struct CohesiveSection {
  std::int64_t n_integration_points = 4;  ///< those of the corners [1]
};

/// BEGIN SHELL SECTION. Without a thickness the mesh's element attribute counts.
struct ShellSection {
  std::optional<double> thickness;                  ///< > 0 [length]
  double thickness_scale_factor = 1.0;              ///< of thickness and mesh variable, > 0 [1]
  std::optional<DeckName> thickness_mesh_variable;  ///< element attribute or variable with the thickness
  double lofting_factor = 0.5;  ///< share of the thickness on the side of the normal, 0 to 1 [1]
  DeckName formulation{"bt_shell", {}};
  DeckName integration_rule{"trapezoid", {}};
  std::int64_t n_integration_points = 5;
  double drilling_stiffness_factor = 0.0;  ///< [1]
  std::optional<DeckName> orientation;     ///< a coordinate system
};

/// BEGIN MEMBRANE SECTION. Without a thickness the mesh's element attribute counts.
struct MembraneSection {
  std::optional<double> thickness;                  ///< > 0 [length]
  double thickness_scale_factor = 1.0;              ///< > 0 [1]
  std::optional<DeckName> thickness_mesh_variable;  ///< element attribute or variable with the thickness
  double lofting_factor = 0.5;                      ///< 0 to 1 [1]
  DeckName formulation{"mean_quadrature", {}};
  std::optional<double> deviatoric_parameter;  ///< 0 to 1 [1]
};

enum class BeamShape : std::uint8_t { rod, tube, bar, box, i };

/// BEGIN BEAM SECTION. Dimensions that the shape does not have stay absent.
struct BeamSection {
  BeamShape shape = BeamShape::rod;
  std::optional<double> width;             ///< along the t axis; the diameter of a rod or tube, > 0 [length]
  std::optional<double> height;            ///< across the t axis, > 0 [length]
  std::optional<double> wall_thickness;    ///< of tube, box and I, > 0 [length]
  std::optional<double> flange_thickness;  ///< of I, > 0 [length]
  std::optional<Eigen::Vector3d> t_axis;   ///< any length [1]
  std::optional<DeckName> reference_axis;
  std::array<double, 2> axis_offset = {0.0, 0.0};  ///< of the section's centre from the element [length]
};

/// BEGIN TRUSS SECTION. Without an area the mesh's element attribute counts.
struct TrussSection {
  std::optional<double> area;  ///< > 0 [length^2]
  double initial_load = 0.0;   ///< [force]
  double period = 0.0;         ///< over which the initial load is brought on [time]
};

/// BEGIN PARTICLE SECTION. Without a radius the mesh's element attribute counts.
struct ParticleSection {
  std::optional<double> radius;  ///< > 0 [length]
};

/// BEGIN POINT MASS SECTION.
struct PointMassSection {
  std::optional<double> mass;                          ///< >= 0 [mass]
  std::optional<double> ixx, iyy, izz, ixy, iyz, izx;  ///< about the node [mass length^2]
};

/// BEGIN SPRING SECTION.
struct SpringSection {
  std::optional<double> area;               ///< > 0 [length^2]
  std::optional<double> default_stiffness;  ///< > 0 [force/length]
  std::optional<DeckName> force_strain_function;
  std::optional<double> mass_per_unit_length;  ///< >= 0 [mass/length]
};

/// BEGIN DAMPER SECTION.
struct DamperSection {
  std::optional<double> area;  ///< > 0 [length^2]
};

/// A section type that contactsim knows by name only; wrong when a block uses it.
struct UnsupportedSection {
  std::string type;  ///< the deck's words in lower case: "superelement section"
};

using SectionProperties = std::variant<SolidSection, TotalLagrangeSection, CohesiveSection, ShellSection,
                                       MembraneSection, BeamSection, TrussSection, ParticleSection,
                                       PointMassSection, SpringSection, DamperSection, UnsupportedSection>;

/// BEGIN <type> SECTION <name>.
struct SectionDefinition {
  DeckName name;
  std::optional<DeckName> rigid_body;  ///< blocks of this section are parts of it
  SectionProperties properties;
};

}  // namespace contactsim
