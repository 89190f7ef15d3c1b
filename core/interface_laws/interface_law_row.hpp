// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/function.hpp"
#include "core/definition/parameter_values.hpp"
#include "core/interface_laws/interface_law.hpp"

/// Words of the laws: the gap is the distance of the surfaces along the normal, > 0 apart; the slip is how
/// far one has moved along the other, its rate how fast. A force or traction that a function gives for a gap
/// pulls the surfaces together when it is positive. In compression every law without a pressure of its own
/// pushes as FRICTIONLESS does; what it says of tension and of forces along the surface comes on top. "At the
/// start" is the first step of the run. Forces, unlike tractions, are those of one contact point: a node, or
/// a pair of faces. Source: Sierra/SM 5.22, 8.5; laws past Coulomb's as in ACME's documentation.
namespace contactsim {

/// What a law is made of.
struct InterfaceLawInput {
  const ParameterValues& values;                  ///< whole: what is required is there
  std::span<const FunctionDefinition> functions;  ///< of the deck
  Diagnostics& diagnostics;

  /// The function of scaled_function(); nothing when an error was added.
  std::optional<LawCurve> curve(const std::string& prefix) const;
  /// The same of one that need not be a curve, without its factor.
  std::optional<Function> function(const std::string& prefix) const;
  double scale(const std::string& prefix) const { return values.real(prefix + " scale factor"); }
};

/// The models among which a law selects.
struct LawSelection {
  std::optional<DeckName> close, far;  ///< by the gap at the start; absent: frictionless
  std::vector<PeriodModel> by_period;  ///< else: frictionless in periods that none names
};

/// An interface law: one block of a contact definition, BEGIN <name> MODEL.
struct InterfaceLawRow {
  std::string name;  ///< lower case: "spring weld"
  std::string help;  ///< one line
  std::vector<Parameter> parameters = {};
  /// Nothing when an error was added. Null: the law is what `holding` says, or selects. What follows the
  /// failure of a weld is not its concern: see failure_parameters().
  std::optional<InterfaceLaw> (*make)(const InterfaceLawInput& input) = nullptr;
  ContactLaw holding = ContactLaw::sliding;  ///< of laws that hold and never fail
  bool holds_at_start = false;               ///< what is near at the start, if only until it fails
  bool has_pressure = false;                 ///< in place of the penalty, which enforces its pairs
  LawSelection (*select)(const ParameterValues& values) = nullptr;  ///< of laws that select others, only
  /// In tables; null: the name.
  std::string (*describe)(const ParameterValues& values) = nullptr;

  /// Whether it may follow a weld that has failed.
  bool slides() const { return holding == ContactLaw::sliding && !holds_at_start && select == nullptr; }
};

/// <prefix> FUNCTION and <prefix> SCALE FACTOR.
///   meaning  what the function maps to what, with dimensions
std::vector<Parameter> scaled_function(const std::string& prefix, const std::string& meaning,
                                       bool is_required = true);

/// FAILURE ENVELOPE EXPONENT.
Parameter envelope_exponent();

/// FAILURE DECAY CYCLES and FAILED MODEL, of what fails: the force at that time fades along a straight line,
/// while another model acts already. They act on any law that has them.
std::vector<Parameter> failure_parameters();

}  // namespace contactsim
