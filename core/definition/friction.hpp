// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "core/definition/condition_lines.hpp"
#include "core/definition/friction_bonds.hpp"
#include "core/definition/friction_pressure.hpp"
#include "core/definition/parameter.hpp"

/// The friction models of a contact definition: what two surfaces do to each other where they touch, and some
/// also where they stand apart.
///
/// Words: the gap is the distance of the surfaces along the normal, > 0 apart; the slip is how far one has
/// moved along the other, its rate how fast. A force or traction that a function gives for a gap pulls the
/// surfaces together when it is positive. In compression every model pushes as FRICTIONLESS does; what it
/// says of tension and of forces along the surface comes on top. "At the start" is the first step of the run.
/// Source: Sierra/SM 5.22, 8.5; laws past Coulomb's as in ACME's documentation.
namespace contactsim {

/// FRICTIONLESS MODEL: normal force only.
struct Frictionless {
  bool operator==(const Frictionless&) const = default;
};

/// CONSTANT FRICTION MODEL: the surfaces stick until the tangential force would pass coefficient * normal
/// force, then they slip under that force (Coulomb).
struct ConstantFriction {
  double coefficient = 0.0;  ///< >= 0 [1]
  bool operator==(const ConstantFriction&) const = default;
};

/// TIED MODEL: what touches at the start stays together, in tension and along the surface too.
struct Tied {
  bool operator==(const Tied&) const = default;
};

/// GLUED MODEL: frictionless until the surfaces touch, tied at that place from then on.
struct Glued {
  bool operator==(const Glued&) const = default;
};

/// ADHESION MODEL: surfaces that are apart by less than the last abscissa of a function pull each other with
/// the traction that it gives for the gap, whether they ever touched or not. There is no friction.
struct Adhesion {
  ScaledFunction adhesion;  ///< gap [length] to traction [force/length^2]
  bool operator==(const Adhesion&) const = default;
};

/// JUNCTION MODEL: surfaces that are apart pull each other with a traction that depends on the gap. Along the
/// surface they stick until the traction would pass g(slip rate), then they slip under it; from the cutoff
/// gap on nothing acts along the surface.
struct Junction {
  ScaledFunction normal;      ///< gap [length] to traction [force/length^2]
  ScaledFunction tangential;  ///< slip rate [length/time] to traction [force/length^2]
  /// NORMAL CUTOFF DISTANCE FOR TANGENTIAL TRACTION >= 0; absent: the last abscissa of `normal` [length]
  std::optional<double> tangential_cutoff;
  bool operator==(const Junction&) const = default;
};

/// HYBRID MODEL: one model for the places that were within the CAPTURE TOLERANCE of the other side at the
/// start, another one for the rest.
struct HybridFriction {
  std::optional<DeckName> initially_close, initially_far;  ///< absent: frictionless
  bool operator==(const HybridFriction&) const = default;
};

/// TIME VARIANT MODEL: another model in each time stepping block, the deck's PERIOD.
struct TimeVariantFriction {
  std::vector<PeriodModel> models;  ///< frictionless in periods that none names
  bool operator==(const TimeVariantFriction&) const = default;
};

using AnyFriction =
    std::variant<Frictionless, ConstantFriction, Tied, Glued, SpringWeld, SurfaceWeld, Adhesion, CohesiveZone,
                 Junction, Threaded, PressureVelocityFriction, HybridFriction, TimeVariantFriction>;

/// One of them; a struct, so that headers can pass it on without knowing the models.
struct FrictionLaw : AnyFriction {
  using AnyFriction::AnyFriction;
};

/// A law for those who keep it without knowing the models.
std::shared_ptr<const FrictionLaw> share_law(FrictionLaw law);

/// BEGIN ... MODEL <name>: a law that interactions use by its name.
struct FrictionModel {
  DeckName name;
  FrictionLaw law;
};

/// The law that a name stands for: the first model so called, else one of FRICTIONLESS and TIED, which need
/// no definition; null when there is none. The result lives as long as `models`.
const FrictionLaw* find_friction_law(std::span<const FrictionModel> models, std::string_view name);

}  // namespace contactsim
