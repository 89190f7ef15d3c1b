// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/definition/section.hpp"

namespace contactsim {

/// A point of integration over a beam's cross-section. t and s are across the beam, s = axis x t.
struct BeamFibre {
  double t = 0.0, s = 0.0;  ///< from the line of the nodes [length]
  double area = 0.0;        ///< that it stands for [length^2]
};

/// A cross-section. Its fibres have its area and second moments; torsion and shear, which no section of
/// points answers for, are scaled to what a real one resists.
struct BeamShapeSettings {
  std::vector<BeamFibre> fibres;
  Eigen::Vector3d t_axis =
      Eigen::Vector3d::Zero();            ///< direction of t at rest, any length; 0: any across the beam
  double area = 0.0;                      ///< [length^2]
  double second_t = 0.0, second_s = 0.0;  ///< of t^2 and of s^2, about the centre of area [length^4]
  double torsion = 0.0;                   ///< Saint-Venant's constant [length^4]
  double shear_t = 1.0, shear_s = 1.0;    ///< share of the area that resists shear along t and s [1]
  bool is_offset = false;                 ///< whether the centre lies beside the nodes
};

/// The cross-section that a BEAM SECTION describes. Nothing when it lacks a size that its shape needs, or
/// walls do not fit into it; `problem` then says so. Source: Young and Budynas, Roark's Formulas for Stress
/// and Strain (2002), tables A.1 and 10.1; Cowper, J. Appl. Mech. 33 (1966) 335-340, for shear.
std::optional<BeamShapeSettings> make_beam_shape(const BeamSection& section, std::string& problem);

}  // namespace contactsim
