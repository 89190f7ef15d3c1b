// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/compare/comparison.hpp"

namespace contactsim {

/// A summary's file.
struct SummaryText {
  std::string path, text;
};

/// What differs between two summaries: how the runs ended, -D values, steps, energies, pairs, warnings by
/// their numbers, errors. Wall times, threads, version, paths and fingerprints do not count. Energies are
/// compared by the largest of all energies, other numbers by the larger of the two. Throws FileError.
std::vector<Difference> compare_summaries(const SummaryText& first, const SummaryText& second,
                                          const Tolerance& tolerance);

}  // namespace contactsim
