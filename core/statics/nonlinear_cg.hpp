// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/definition/solver.hpp"
#include "core/statics/equilibrium.hpp"

namespace contactsim {

/// How a search for equilibrium ended.
struct CgReport {
  enum class End : std::uint8_t {
    converged,   ///< below the target
    acceptable,  ///< not below the target within the iterations, but below what is acceptable
    failed
  };
  End end = End::failed;
  std::int64_t n_iterations = 0;
  std::int64_t n_evaluations = 0;  ///< of the residual
  std::int64_t n_linear = 0;       ///< iterations of linear equations
  bool meets_negative = false;     ///< a direction of negative stiffness has been met
  double residual = 0.0;           ///< its size at the end [force]
  double reference = 0.0;          ///< what it is compared with [force]
};

/// Notes what a residual comes to. Returns whether it is below the target.
///   size  of the residual [force]
bool is_balanced(const Equilibrium& equilibrium, double size, const CgSettings& settings, CgReport& report);

/// Searches for equilibrium by preconditioned nonlinear conjugate gradients: directions of Polak and Ribiere
/// that begin anew where they would turn back, along each of which a secant search finds where the residual
/// is at right angles to it. What cannot be evaluated halves the way. The last evaluation is the one of the
/// increment that is returned.
/// Source: Nocedal and Wright, Numerical Optimization, 2nd ed. (2006), 5.2, eq. 5.44 and 5.45; Sierra/SM
/// Theory Manual 5.20, chapter 13.
///   increment  in: where to begin, which can be evaluated; out: where the search ended
CgReport nonlinear_cg(Equilibrium& equilibrium, const Preconditioner& preconditioner,
                      const CgSettings& settings, Eigen::VectorXd& increment);

/// Improves an increment by linear conjugate gradients on the equilibrium linearised there, by differences of
/// residuals, such that prescribed directions may move far without turning elements inside out on the way.
/// Source: Knoll and Keyes, J. Comput. Phys. 193 (2004) 357-397, eq. 10.
///   prescribed  what fixed and prescribed directions still have to move, 0 of the others
///   increment   in: where to linearise; out: with the prescribed part in any case, and what balances it
///   linearly
/// Returns the number of evaluations of the residual.
std::int64_t predict_linearly(Equilibrium& equilibrium, const Preconditioner& preconditioner,
                              const Eigen::VectorXd& prescribed, std::int64_t max_iterations,
                              Eigen::VectorXd& increment);

}  // namespace contactsim
