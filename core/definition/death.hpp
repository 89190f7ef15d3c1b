// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "core/definition/entity_set.hpp"
#include "core/definition/output_variable.hpp"

namespace contactsim {

enum class Comparison : std::uint8_t { less, less_equal, equal, greater_equal, greater };

/// variable <op> value.
struct VariableTest {
  VariableReference variable;
  Comparison comparison = Comparison::greater;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< in the variable's dimension
};

/// CRITERION IS {AVG|MAX|MIN} NODAL VALUE OF ...: over the nodes of the element.
struct NodalCriterion {
  enum class Reduction : std::uint8_t { average, maximum, minimum };
  Reduction reduction = Reduction::average;
  VariableTest test;
};

/// CRITERION IS ELEMENT VALUE OF ... [KILL WHEN <n> INTEGRATION POINTS REMAIN].
struct ElementCriterion {
  VariableTest test;
  std::optional<std::int64_t>
      remaining_points;  ///< that do not meet the test when the element dies; absent: program's
};

/// CRITERION IS GLOBAL VALUE OF ...: kills the whole set.
struct GlobalCriterion {
  VariableTest test;
};

/// CRITERION IS ALWAYS TRUE.
struct AlwaysCriterion {};

/// MATERIAL CRITERION = ON [KILL WHEN <n> INTEGRATION POINTS REMAIN]: the material model says so.
struct MaterialCriterion {
  std::optional<std::int64_t> remaining_points;
};

using DeathCriterion =
    std::variant<NodalCriterion, ElementCriterion, GlobalCriterion, AlwaysCriterion, MaterialCriterion>;

/// LOGFILE OUTPUT: how much the log tells of deaths. minimal: how many died; some: also which surfaces of
/// contact have changed; full: also the whole table of their owners.
enum class DeathLog : std::uint8_t { minimal, some, full };

/// BEGIN ELEMENT DEATH <name>: an element of the set dies when any criterion holds. Source: Sierra/SM 5.20,
/// element death.
struct ElementDeath {
  DeckName name;
  EntitySet set;
  std::vector<DeckName> materials;  ///< INCLUDE BLOCKS WITH MATERIAL: their blocks are added to the set
  std::vector<DeathCriterion> criteria;
  std::int64_t check_step_interval = 1;       ///< steps between two checks, >= 1
  std::optional<double> check_time_interval;  ///< least time between two checks, > 0 [time]
  std::optional<double> start_time;           ///< none dies before it [time]
  bool on_inversion = false;                  ///< an inverted element dies
  bool on_ill_defined_contact = false;        ///< an element dies whose contact faces have lost their shape
  std::int64_t death_steps = 1;               ///< steps over which the stress of a dying element fades, >= 1
  bool cleans_contact_aggressively = false;   ///< a solid that has lost its last face neighbour dies
  /// NODAL EROSION: nodes of dead elements only leave contact, as if these had never been there. Source:
  /// Sierra/SM 5.20, section 8.4.8.4.
  bool erodes_nodes = true;
  bool makes_new_edges = true;  ///< NEW EDGES ON DEATH: edges of exposed faces are feature edges as others
  DeathLog log = DeathLog::some;
  std::optional<std::int64_t> summary_step_interval;  ///< steps between two lines of the log, >= 1
  std::optional<double> summary_time_interval;        ///< time between two lines of the log, > 0 [time]
};

}  // namespace contactsim
