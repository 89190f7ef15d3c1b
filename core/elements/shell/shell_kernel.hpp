// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/elements/shell_settings.hpp"
#include "core/elements/solid_kernel.hpp"

/// What every kernel of a shell takes and gives. Shells have a frame of their own that moves with them: z
/// along the normal, x and y in the surface. Velocities psi = (w_y, -w_x) of the normal's tip stand for the
/// angular velocity w there.
namespace contactsim {

/// How eight shells of n nodes move in a step.
template <std::size_t n>
struct ShellMotion {
  NodeVectors<n> x;  ///< coordinates at the end of the step [length]
  NodeVectors<n> v;  ///< velocities at its middle [length/time]
  NodeVectors<n> w;  ///< angular velocities at its middle [1/time]
  Lanes mass;        ///< of the elements [mass]
  Lanes inertia;     ///< rotational, of the elements [mass length^2]
  Lanes thickness;   ///< at the start of the step [length]
  double dt = 0.0;   ///< size of the step; 0: forces at the start are asked for [time]
};

/// What a step gives.
template <std::size_t n>
struct ShellStep {
  NodeVectors<n> force;   ///< as it acts on the nodes at the end of the step [force]
  NodeVectors<n> moment;  ///< the same [force length]
  Lanes volume;           ///< at the end of the step [length^3]
  Lanes stable_step;      ///< [time]
  Lanes stress_work;      ///< done on the material's stress in the step [energy]
  Lanes hourglass_work;   ///< done on the hourglass forces in the step, those of drilling too [energy]
  Lanes viscous_work;     ///< done on the bulk viscosity in the step [energy]
};

/// How fast shells deform, in their frame; or the forces against it, such that the products of both sum to a
/// power. `hourglass` are those of the hourglass modes, nodal motions that the other rates do not see.
template <std::size_t n_modes>
struct ShellRates {
  std::array<Lanes, 3> membrane;   ///< xx, yy and the angle xy
  std::array<Lanes, 3> curvature;  ///< the same of the change along the normal
  std::array<Lanes, 2> shear;      ///< the angles zx and yz
  std::array<Lanes, n_modes> hourglass;
};

/// What bounds the frequencies of shells. With B the gradients of the shape functions, rows are what a rate
/// takes from every node's velocity or angular velocity.
struct ShellSizes {
  Lanes area;                 ///< [length^2]
  std::array<Lanes, 3> gram;  ///< B B^T: xx, yy, xy [1/length^2]
  Lanes warp;                 ///< norm of the surface's own curvature [1/length]
  Lanes tilt;                 ///< bound for the squared slope of the surface at the nodes [1]
  Lanes shear_by_turning;     ///< squared norm of the rows of shear by angular velocities [1]

  Lanes gram_trace() const { return gram[0] + gram[1]; }
  Lanes gram_eigenvalue() const {
    const Lanes half = 0.5 * (gram[0] - gram[1]);
    return 0.5 * gram_trace() + (half * half + gram[2] * gram[2]).sqrt();
  }
};

/// What resists an hourglass mode.
enum class HourglassKind : std::uint8_t { membrane, bending, shear };

/// The squared norms of an hourglass mode's rows; of modes at right angles to one another the first has all
/// and the others have none.
struct HourglassSizes {
  Lanes by_moving, by_turning;
  Lanes scale;  ///< of the stiffness: as kernels of shells say
};

/// Share of the transverse shear that a uniform stress would resist. Source: Reissner (1945).
inline constexpr double shear_correction = 5.0 / 6.0;

}  // namespace contactsim
