// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "core/definition/contact_options.hpp"
#include "core/definition/surface_smoothing.hpp"

namespace contactsim {

/// What meets what in a pair of surfaces.
enum class ConstraintFormulation : std::uint8_t { node_face, face_face };

/// How a pair moves. infinitesimal_sliding keeps the partners found at the start and their planes;
/// no_interaction switches the pair off.
enum class InteractionBehavior : std::uint8_t { sliding, infinitesimal_sliding, no_interaction };

/// PENALTY STIFFNESS = AUTO or a number: force per area of contact and per depth.
struct PenaltyStiffness {
  std::optional<double> given;  ///< absent: AUTO, from the elements of both sides; > 0 [force/length^3]
  bool operator==(const PenaltyStiffness&) const = default;
};

/// How the gap that contact counts with differs from that of the mesh. Of the last three a pair has one at
/// most.
struct GapSettings {
  std::optional<double> contact_offset;        ///< taken off every gap; program: 0 [length]
  std::optional<double> initial_clearance;     ///< gap that counts at the start, < 0 overlaps [length]
  std::optional<bool> ignore_initial_overlap;  ///< overlaps of the start count as just touching; program: no
  std::optional<double> overlap_ramp_time;     ///< in which overlaps of the start come to count, > 0 [time]
  bool operator==(const GapSettings&) const = default;

  /// Whether gaps of the start have to be remembered.
  bool needs_start() const {
    return initial_clearance || overlap_ramp_time || ignore_initial_overlap.value_or(false);
  }
};

/// CONTACT STABILIZATION of load steps: sides that are near each other resist their relative motion, less and
/// less until a time stepping block ends. Source: Abaqus, *CONTACT STABILIZATION; OptiStruct, CNTSTB.
struct StabilizationSettings {
  std::optional<double> scale;                ///< of the automatic coefficient, >= 0; program: 0 [1]
  std::optional<double> tangential_fraction;  ///< of it along the surface, >= 0; program: 0.1 [1]
  std::optional<double> remaining_fraction;   ///< of both at the end of a block, 0 to 1; program: 0 [1]
  std::optional<double> range;  ///< gap from which on nothing resists, > 0; program: the mean edge [length]
  bool operator==(const StabilizationSettings&) const = default;

  bool is_on() const { return scale.value_or(0.0) > 0.0; }
};

/// GAP CLOSURE TOLERANCE = AUTO or a number: gaps up to it are closed by moving nodes before the first step.
struct GapClosureTolerance {
  std::optional<double> given;  ///< absent: AUTO, a share of the mean edge of the faces; >= 0 [length]
  bool operator==(const GapClosureTolerance&) const = default;
};

/// SEARCH DISTANCE = AUTO or a number: what is farther from the other side at the start is never looked at.
struct SearchDistance {
  std::optional<double> given;  ///< absent: AUTO, two mean edges of the faces; >= 0 [length]
  bool operator==(const SearchDistance&) const = default;
};

/// Which side of shells other surfaces meet: the top is the one that the normal looks out of.
enum class ShellSides : std::uint8_t { both, top, bottom };

/// The settings of a pair of surfaces. One that is absent in an INTERACTION comes from INTERACTION DEFAULTS;
/// one absent there too is the program's.
struct PairSettings {
  std::optional<DeckName> friction_model;            ///< program: frictionless
  std::optional<ConstraintFormulation> formulation;  ///< program: face_face
  std::optional<InteractionBehavior> behavior;       ///< program: sliding
  std::optional<Enforcement> enforcement;            ///< program: momentum_balance
  std::optional<double> normal_tolerance;            ///< reach of the search off a face, >= 0 [length]
  std::optional<double> tangential_tolerance;        ///< reach beyond a face's edge, >= 0 [length]
  std::optional<double>
      overlap_normal_tolerance;  ///< deepest overlap that is removed at the start, >= 0 [length]
  std::optional<double> overlap_tangential_tolerance;  ///< the same beyond a face's edge, >= 0 [length]
  std::optional<double> capture_tolerance;             ///< gap over which what holds does so, >= 0 [length]
  std::optional<bool> separation;                      ///< whether what has touched may part; program: yes
  std::optional<ShellSides> sides;                ///< of SIDE A's shells, without sides of all; program: both
  std::optional<double> tracking_distance;        ///< gaps up to it are output, >= 0 [length]
  std::optional<SearchDistance> search_distance;  ///< program: everything is looked at
  GapSettings gap;
  std::optional<GapClosureTolerance> gap_closure;     ///< program: none is closed
  std::optional<DeckName> adjusted_nodes;             ///< node set whose nodes go onto the other side
  std::optional<SmoothingChoice> smoothing;           ///< round shapes of the sides; program: off
  std::optional<double> penalty_scale;                ///< of the automatic stiffness, > 0; program: 1 [1]
  std::optional<PenaltyStiffness> penalty_stiffness;  ///< program: automatic
  std::optional<double> damping_fraction;             ///< of critical damping, >= 0; program: 0 [1]
  StabilizationSettings stabilization;
};

/// The settings of a pair with what is absent taken from the defaults.
PairSettings with_defaults(PairSettings own, const PairSettings& defaults);

/// EXCLUDE SURFACES <names> of the defaults: no pair among the surfaces meets, whatever interactions say.
struct SurfaceExclusion {
  DeckLocation location;
  std::vector<DeckName> surfaces;  ///< one alone: with itself; ALL: each of the others with every surface
};

/// BEGIN INTERACTION DEFAULTS [name]. Without it, and without any INTERACTION, nothing touches.
/// Source: Sierra/SM 5.22, 8.6.1.
struct InteractionDefaults {
  DeckName name;
  bool general_contact = false;    ///< every surface meets every other
  bool self_contact = false;       ///< every surface meets itself
  std::vector<DeckName> surfaces;  ///< the contact surfaces that general and self contact take; none: all
  std::vector<SurfaceExclusion> exclusions;
  PairSettings pair;
};

/// BEGIN INTERACTION [name]: pairs that are treated their own way; a later one overrides an earlier one for
/// the same pair, and one with NO_INTERACTION all of them. Either `surfaces` or both sides are given; ALL of
/// a side stands for every surface. Source: Sierra/SM 5.22, 8.6.2; exclusions and ALL: Abaqus, *CONTACT
/// EXCLUSIONS.
struct Interaction {
  DeckName name;
  std::vector<DeckName> surfaces;  ///< every pair among them; one that is alone or listed twice meets itself
  std::vector<DeckName> side_a;    ///< SIDE A, older MASTER: with node_face these give the faces
  std::vector<DeckName> side_b;    ///< SIDE B, older SLAVE: with node_face these give the nodes
  PairSettings pair;
  std::optional<double> friction_coefficient;  ///< Coulomb, in place of a friction model, >= 0 [1]
  ActivePeriods periods;
};

}  // namespace contactsim
