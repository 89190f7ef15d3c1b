// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/output/output_plan.hpp"

namespace contactsim {

/// What a run would come to, as its start and a few steps let expect.
struct RunEstimate {
  double stable_step = 0.0;       ///< at the start, not scaled [time]
  double step = 0.0;              ///< that the run begins with [time]
  std::int64_t n_steps = 0;       ///< of that size, up to the termination time
  std::size_t n_elements = 0;     ///< with deformation
  double seconds_per_step = 0.0;  ///< of the clock, mean of those taken

  std::vector<OutputEstimate> files;  ///< results, histories, heartbeats

  double element_steps() const { return static_cast<double>(n_steps) * static_cast<double>(n_elements); }
  double seconds() const { return static_cast<double>(n_steps) * seconds_per_step; }
};

}  // namespace contactsim
