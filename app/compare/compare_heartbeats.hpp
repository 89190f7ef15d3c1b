// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/compare/comparison.hpp"

namespace contactsim {

/// Values over time, as a heartbeat in CSV holds them.
struct HeartbeatTable {
  std::vector<std::string> names;            ///< of the columns; the first is the time
  std::vector<std::vector<double>> columns;  ///< [n names] each [n lines]
  std::size_t n_lines() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Reads one; lines of units and of comments do not count. Throws FileError naming the line that is not as it
/// should be.
HeartbeatTable read_heartbeat(const std::string& path, const std::string& text);

/// What differs: of each column the first time at which it passes the tolerance, both values, and the largest
/// difference; columns and lines that only one has. Lines are compared in their order; a number is compared
/// by the largest of its column, times too.
std::vector<Difference> compare_heartbeats(const HeartbeatTable& first, const HeartbeatTable& second,
                                           const Tolerance& tolerance);

}  // namespace contactsim
