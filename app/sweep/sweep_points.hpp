// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/sweep/sweep_parameter.hpp"

namespace contactsim {

/// Names of -D and their values in one run.
using SweepPoint = std::vector<std::pair<std::string, std::string>>;

/// Which runs a study has.
struct SweepPlan {
  std::vector<SweepParameter> parameters;
  std::optional<std::string> points_file;  ///< CSV: names, then a line per point
  std::optional<std::size_t> n_samples;    ///< of a Latin hypercube over ranges and lists, in place of all
  std::uint64_t seed = 1;                  ///< of the samples
  double max_runs = 1e4;                   ///< more are refused
};

/// A run of a study.
struct SweepRun {
  std::size_t number = 0;  ///< from 1
  SweepPoint point;
  std::string folder;  ///< below that of the study
};

/// Every run of a plan: all combinations, the last parameter changing fastest; or samples; each with each
/// point of the file, which go slowest. Two plans that share a point share its folder. Throws DeckError when
/// there are none or too many, when a name stands twice, or two points are the same; FileError.
std::vector<SweepRun> list_runs(const SweepPlan& plan);

/// "mu=0.1 order=1".
std::string describe_point(const SweepPoint& point);

/// The folder of a point: "mu=0.1_order=1"; with a fingerprint where names and values do not make a short
/// name of a folder.
std::string folder_of(const SweepPoint& point);

}  // namespace contactsim
