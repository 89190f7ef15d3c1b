// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/mesh.hpp"
#include "support/deck_dump.hpp"

namespace contactsim::test {

/// A deck around the lines of a region, bound for a mesh that must outlive it. Its region has the periods p1
/// from 0, p2 from 1 and p3 from 2 [time]. Lines of the region stand in the file "c.i" from line 1; outside
/// are, in "d.i", the functions one (1), ramp (its abscissa), bad (1/x at 0: not finite), at_x (2 coordinates
/// x), of_stress; the points origin, right (1 0 0); the directions up (0 0 2), slanted (3 4 0), across (-4 3
/// 0) and the axes spin (z through the origin) and rightward (x).
class ConditionDeck {
 public:
  /// start   of the first period [time]
  /// stored  results of the mesh file; must outlive this
  ConditionDeck(const Mesh& mesh, const std::string& region_lines, double start = 0.0,
                const StoredVariables* stored = nullptr);

  ConditionScope scope() { return {definition_, region(), time_blocks(), mesh_, diagnostics_, stored_}; }
  const Region& region() const { return definition_.procedures.front().regions.front(); }
  /// All that was found wrong, in machine form.
  std::string messages() const { return contactsim::messages(diagnostics_); }

 private:
  const std::vector<TimeSteppingBlock>& time_blocks() const {
    return definition_.procedures.front().time_control->time_stepping_blocks;
  }

  const Mesh& mesh_;
  SimulationDefinition definition_;
  Diagnostics diagnostics_;
  const StoredVariables* stored_;
};

}  // namespace contactsim::test
