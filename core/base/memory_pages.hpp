// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>

namespace contactsim {

/// Sets numbers to zero and gives the pages that they fill back to the system: what stays zero takes no
/// memory, and what reads it reads one page of zeros. Where the system does not do so they are just set.
///   values  on the heap
void set_zero_without_memory(std::span<double> values);

inline void set_zero_without_memory(Eigen::Matrix3Xd& values) {
  set_zero_without_memory({values.data(), static_cast<std::size_t>(values.size())});
}

/// Gives back what has been freed and no later array has taken.
void return_freed_memory();

}  // namespace contactsim
