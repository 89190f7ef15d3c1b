// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/curves.hpp"
#include "app/run/simulation.hpp"

namespace contactsim {

/// Notes what a run comes to while it goes on: energies, and force and penetration of each pair that touches.
/// Of a long run every 2nd, 4th, 8th, ... step is kept, so that there are at most 1000.
class RunCurves {
 public:
  /// An observer of the run.
  void look(RunEvent event, const Simulation& run);
  /// Energies; forces and penetrations of the pairs with the largest, by their names.
  std::vector<CurveChart> charts() const;

 private:
  /// A pair's values; those before its first touch are zero.
  struct PairCurve {
    std::vector<double> force;        ///< norm of the net force [force]
    std::vector<double> penetration;  ///< deepest of what touches [length]
  };

  /// Position and name: procedures have pairs of their own.
  using PairKey = std::pair<std::uint32_t, std::string>;

  void note(const Simulation& run);
  void note_pairs(const Simulation& run);
  void thin_out();
  CurveChart pair_chart(const char* title, const char* dimension,
                        std::vector<double> PairCurve::*values) const;

  std::int64_t stride_ = 1;
  std::optional<std::int64_t> last_step_;
  std::vector<double> times_;
  std::vector<std::vector<double>> energies_;
  std::map<PairKey, PairCurve> pairs_;
};

}  // namespace contactsim
