// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/names.hpp"

namespace contactsim {

/// BEGIN SEARCH OPTIONS. Source: Sierra/SM 5.22, 8.9.
struct SearchOptions {
  enum class Tolerance : std::uint8_t { automatic, user_defined };

  bool global_search_once = false;  ///< at the start only
  Tolerance tolerance = Tolerance::automatic;
  std::optional<double> normal_tolerance;      ///< reach off a face, >= 0 [length]
  std::optional<double> tangential_tolerance;  ///< reach beyond a face's edge, >= 0 [length]
  std::optional<double> capture_tolerance;     ///< gap over which what holds does so, >= 0 [length]
};

/// BEGIN DASH OPTIONS. Source: Sierra/SM 5.22, 8.9.
struct DashOptions {
  double search_length_scaling = 0.15;  ///< search distance over face size, >= 0 [1]
};

/// How the sides of a pair are kept apart. momentum_balance: by forces that let nothing through at the end of
/// the step, from masses and the step; penalty: by an elastic force that grows with the penetration;
/// augmented_lagrange: by that made exact with multipliers, of quasi-static procedures.
enum class Enforcement : std::uint8_t { momentum_balance, penalty, augmented_lagrange };

/// BEGIN ENFORCEMENT OPTIONS, and the line ENFORCEMENT of the contact definition. Source: Sierra/SM 5.22, 8.2
/// and 8.9.
struct EnforcementOptions {
  std::optional<Enforcement> enforcement;  ///< of pairs that say nothing else
  std::int64_t balance_iterations = 20;    ///< MOMENTUM BALANCE ITERATIONS, the most of a step, >= 1
  double penalty_scale = 1.0;              ///< of all pairs, times their own, > 0 [1]
  bool is_static = false;  ///< the procedure is quasi-static: pairs know neither momentum nor rates
};

/// BEGIN SURFACE OPTIONS, older SHELL LOFTING: how lofted elements of some contact surfaces get their
/// geometry. Source: Sierra/SM 5.22, 8.9.
struct SurfaceOptions {
  enum class ShellThickness : std::uint8_t { actual_thickness, let_contact_choose };
  enum class CoincidentShells : std::uint8_t { disallow, ignore, simple };
  enum class CoincidentShellHexes : std::uint8_t { disallow, ignore, tapered, embedded };

  DeckName name;
  std::vector<DeckName> surfaces;          ///< contact surfaces; none: all
  std::vector<DeckName> removed_surfaces;  ///< taken away again
  std::optional<double> beam_radius;       ///< in place of the section's, > 0 [length]
  std::optional<bool> has_edge_contact;    ///< whether edges meet edges; absent: they do
  std::optional<double> feature_angle;     ///< edges of faces that turn by more are sharp, >= 0 [degrees]
  ShellThickness shell_thickness = ShellThickness::actual_thickness;
  double smallest_shell_thickness = 0.1;  ///< of let_contact_choose, over the edge length [1]
  double largest_shell_thickness = 1.0;   ///< of let_contact_choose, over the edge length [1]
  CoincidentShells coincident_shells = CoincidentShells::disallow;
  CoincidentShellHexes coincident_shell_hexes = CoincidentShellHexes::disallow;
};

/// INITIAL OVERLAP REMOVAL, BEGIN REMOVE INITIAL OVERLAP and OVERLAP REMOVAL ONLY: nodes are moved before the
/// first step so that surfaces do not overlap. Source: Sierra/SM 5.22, 8.9.4.
struct OverlapRemoval {
  std::optional<bool> is_asked_for;  ///< INITIAL OVERLAP REMOVAL = ON or OFF
  bool has_block = false;        ///< BEGIN REMOVE INITIAL OVERLAP, which asks for it when no such line stands
  bool is_all_there_is = false;  ///< OVERLAP REMOVAL ONLY: the run stops after it
  std::optional<double>
      normal_tolerance;  ///< deepest overlap that is removed; absent: automatic, >= 0 [length]
  std::optional<double>
      tangential_tolerance;            ///< the same beyond a face's edge; absent: automatic, >= 0 [length]
  std::int64_t iterations = 10;        ///< >= 1
  std::int64_t shell_iterations = 10;  ///< over lofts, >= 1
  double shell_tolerance = 0.0;        ///< overlap of lofts that is left, >= 0 [length]

  bool is_on() const { return is_asked_for.value_or(has_block); }
};

/// COMPUTE CONTACT VARIABLES: when contact output is computed. Sums over time are always kept.
enum class ContactVariables : std::uint8_t { when_written, every_step };

/// BEGIN DEBUG. Source: Sierra/SM 5.22, 8.10.1.
struct ContactDebug {
  bool visualizes_facets = false;   ///< the contact facets become a mesh of their own in the results
  bool writes_constraints = false;  ///< surfaces and pairs are written out
  std::int64_t output_level = 0;    ///< more is logged with a higher level, >= 0
};

}  // namespace contactsim
