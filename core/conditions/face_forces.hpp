// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

/// Loads on bilinear quadrilaterals, consistent with their shape functions. A triangle repeats its last
/// corner; its shape functions are then the linear ones. Four Gauss points are exact for pressures that are
/// bilinear over the face, warped or not, and for tractions on flat parallelograms and triangles.
/// Source: Belytschko, Liu, Moran & Elkhodary, Nonlinear Finite Elements (2014), 4.9.4.
namespace contactsim {

/// One column per corner of a face, in right-hand order about its outward normal.
using Corners = Eigen::Matrix<double, 3, 4>;

/// Forces at the corners of a pressure, which pushes against the outward normal [force].
///   corners   now [length]
///   pressure  at each corner [force/length^2]
Corners pressure_forces(const Corners& corners, const Eigen::Vector4d& pressure);

/// The same of a pressure that is one number all over the face, integrated in closed form.
Corners pressure_forces(const Corners& corners, double pressure);

/// The same of a traction along a vector that does not turn with the face.
///   traction   at each corner [force/length^2]
///   direction  unit, or the sum of some units [1]
Corners traction_forces(const Corners& corners, const Eigen::Vector4d& traction,
                        const Eigen::Vector3d& direction);

}  // namespace contactsim
