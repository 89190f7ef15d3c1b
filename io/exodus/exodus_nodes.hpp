// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

/// Reads the coordinates of all nodes from either layout (coordx, coordy, coordz or coord): 3 x n_nodes
/// [length]. Throws FileError for too many nodes, missing coordinates, and NaN or infinite ones.
Eigen::Matrix3Xd read_coordinates(const ExodusFile& file);

/// Reads a number map, such as node_num_map: the user's ids by position, empty when they are 1..n or absent.
/// Warns of ids that repeat. `what` is "node" or "element".
std::vector<std::int64_t> read_ids(const ExodusFile& file, const std::string& variable_name, std::size_t n,
                                   const std::string& what, Diagnostics& warnings);

}  // namespace contactsim
