// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/statics/nonlinear_cg.hpp"
#include "core/statics/static_problem.hpp"

namespace contactsim {

/// What to say of a search that has found no equilibrium: "after 100 iterations 3.1 of forces are left over,
/// 0.02 of their reference 155, most at node 12".
///   residual  that the search has ended with; empty where there is none
std::string describe_imbalance(const StaticProblem& problem, const Mesh& mesh, const CgReport& search,
                               const Eigen::VectorXd& residual);

/// What to say behind it of rigid bodies that conditions do not hold, by their numbers; nothing without any.
std::string name_free_bodies(const StaticProblem& problem, std::span<const std::uint32_t> free);

}  // namespace contactsim
