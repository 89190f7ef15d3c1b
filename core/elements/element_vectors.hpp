// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace contactsim {

/// A vector at each of an element's nodes [3 x n_nodes].
using ElementVectors = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 27>;

}  // namespace contactsim
