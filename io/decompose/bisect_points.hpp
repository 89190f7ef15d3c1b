// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace contactsim {

/// Divides points into parts of equal numbers, or numbers that differ by one, by recursive coordinate
/// bisection: across the longest side of the box around them, in the order of that coordinate and then of the
/// points.
///   points   3 x n_points [length]
///   n_parts  at least 1
/// Returns the part of each point. Source: Berger & Bokhari, IEEE Trans. Computers C-36 (1987) 570-580.
std::vector<std::uint32_t> bisect_points(const Eigen::Matrix3Xd& points, std::uint32_t n_parts);

}  // namespace contactsim
