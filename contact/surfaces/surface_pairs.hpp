// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/surfaces/contact_surface.hpp"
#include "core/base/contact_indices.hpp"
#include "core/base/diagnostics.hpp"
#include "core/base/indexed_vector.hpp"
#include "core/base/optional_index.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/interaction.hpp"

namespace contactsim {

/// The law of pairs for which the deck names none.
std::shared_ptr<const FrictionLaw> frictionless_law();

/// Two contact surfaces that may touch each other, and how: the deck's settings, with what it leaves out
/// taken from its defaults and then from the program's.
struct SurfacePair {
  /// Equal for self contact. One-sided: `first` gives the faces (a plane counts as
  /// one), `second` the nodes. Else first <= second.
  SurfaceIndex first, second;
  bool is_one_sided = false;  ///< NODE_FACE with sides, or one of the two cannot give the faces or the nodes
  std::string interaction;    ///< its name, "interaction 3" without one, "general contact", "self contact"
  DeckLocation location;      ///< of the interaction, or of the defaults
  bool is_from_defaults = false;  ///< by general or self contact, no interaction names it
  std::shared_ptr<const FrictionLaw> law = frictionless_law();           ///< never null
  ConstraintFormulation formulation = ConstraintFormulation::face_face;  ///< face_face: both have faces
  InteractionBehavior behavior = InteractionBehavior::sliding;           ///< never no_interaction
  std::optional<double> normal_tolerance;          ///< reach off a face; absent: automatic [length]
  std::optional<double> tangential_tolerance;      ///< reach beyond an edge; absent: automatic [length]
  std::optional<double> overlap_normal_tolerance;  ///< deepest overlap removed; absent: automatic [length]
  std::optional<double>
      overlap_tangential_tolerance;         ///< the same beyond an edge; absent: automatic [length]
  std::optional<double> capture_tolerance;  ///< gap over which what holds does so; absent: automatic [length]
  std::optional<double>
      tracking_distance;  ///< gaps up to it are output; absent: the search's margin [length]
  std::optional<SearchDistance> search_distance;  ///< what is farther at the start is never looked at
  bool separates = true;                          ///< what has touched may part again
  std::array<ShellSides, 2> sides{};              ///< of the shells of `first` and `second` that take part
  GapSettings gap;
  std::optional<GapClosureTolerance> gap_closure;  ///< nodes this near are moved onto the other side
  std::optional<DeckName> adjusted_nodes;          ///< node set of nodes that are, at any distance
  OptionalIndex<std::uint32_t> adjusted_node_set;  ///< of the mesh, with that name
  SmoothingChoice smoothing_choice;                ///< of the deck
  OptionalIndex<std::uint32_t> smoothing;          ///< of the contact model, by that choice
  OptionalIndex<SurfaceIndex>
      side_b;  ///< surface that SIDE B names, or that gives the nodes; its nodes are moved then
  Enforcement enforcement = Enforcement::penalty;
  double penalty_scale = 1.0;               ///< the pair's times that of all pairs [1]
  std::optional<double> penalty_stiffness;  ///< absent: automatic [force/length^3]
  double damping_fraction = 0.0;            ///< of critical damping [1]
  StabilizationSettings stabilization;      ///< of load steps
  ActivePeriods periods;                    ///< of the interaction, less those in which others act

  /// Whether nodes are moved onto the other side before the first step.
  bool closes_gaps() const { return gap_closure || adjusted_nodes; }
  /// How far apart sides are held that have touched: by NORMAL TOLERANCE, else half of the thinner element;
  /// 0 of those that may part [length].
  ///   thickness  of the thinner element [length]
  double held_gap(double thickness) const {
    return separates ? 0.0 : normal_tolerance.value_or(0.5 * thickness);
  }
  /// Whether only one side of some shells takes part.
  bool is_polar() const { return sides[0] != ShellSides::both || sides[1] != ShellSides::both; }
  /// Share of a node's area that counts where it meets a face: pairs that go both ways meet everything twice
  /// [1].
  double node_share() const { return is_one_sided ? 1.0 : 0.5; }
};

using SurfacePairs = IndexedVector<PairIndex, SurfacePair>;

/// The pairs that a contact definition asks for, sorted by (first, second); those of the same surfaces take
/// turns by their periods. General contact pairs every surface with every other, self contact with itself. A
/// named interaction overrides both for its pairs, a later one an earlier one, and one with NO_INTERACTION
/// or EXCLUDE SURFACES takes them out, wherever it stands. A side that both ways name, or FACE_FACE, makes a
/// pair two-sided again. Nodes meet faces and planes only, planes never each other.
///   surfaces     resolved; names that are not among them are passed over, since they are errors elsewhere
///   diagnostics  gets an error for an interaction none of whose surfaces can meet, and the warning
///                "contact-without-pairs" when nothing meets at all, "interaction-overridden" and
///                "exclusion-without-effect"
/// Source: Sierra/SM 5.22, 8.6.
SurfacePairs make_surface_pairs(const ContactDefinition& contact, const ContactSurfaces& surfaces,
                                Diagnostics& diagnostics);

}  // namespace contactsim
