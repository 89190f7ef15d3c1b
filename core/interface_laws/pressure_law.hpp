// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/function.hpp"
#include "core/functions/function.hpp"

namespace contactsim {

/// How hard two sides press each other, by how far they have closed since the pressure began: there they may
/// be apart still, or overlap. The pressure never falls, and being a function of the depth alone it gives
/// back what work was done on it. Source: *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE of Abaqus and CalculiX.
class PressureLaw {
 public:
  /// Straight lines; the last one goes on.
  ///   points  overclosure [length] and pressure [force/length^2]: at least two, overclosures ascend,
  ///   pressures
  ///           do not fall and begin at 0
  static PressureLaw by_points(std::vector<FunctionPoint> points);
  /// p = p0 / (e - 1) x (e^x - 1), x = overclosure / c0 + 1; from x = 10 on it goes on straight.
  ///   pressure   p0 > 0 at a gap of 0 [force/length^2]
  ///   clearance  c0 > 0, the gap at which it begins [length]
  static PressureLaw exponential(double pressure, double clearance);
  /// A function of the overclosure that is 0 at a gap of 0, times a factor.
  static PressureLaw by_function(Function function, double factor);

  /// The gap at which the pressure begins, < 0 where the sides overlap then [length].
  double begin_gap() const { return begin_gap_; }
  /// The pressure at a depth behind there, 0 in front of it [force/length^2].
  double at(double depth) const;
  /// Its integral up to a depth >= 0: the stored energy per area [force/length].
  double potential(double depth) const;
  /// The largest slope up to a depth, for the stable step [force/length^3].
  double slope(double depth) const;

 private:
  struct Line {
    double begin = 0.0, pressure = 0.0, slope = 0.0;  // at its beginning, and along it
    double steepest = 0.0, potential = 0.0;           // of lines up to this one; at its beginning
  };
  struct Lines {
    std::vector<Line> lines;  // ascending, the first one from depth 0
    const Line& of(double depth) const;
    double at(double depth) const;
    double potential(double depth) const;
    double slope(double depth) const { return of(depth).steepest; }
  };
  struct Exponential {
    double factor = 0.0, clearance = 0.0;
    double at(double depth) const;
    double potential(double depth) const;
    double slope(double depth) const;
  };
  struct Analytic {
    Function function;
    double factor = 1.0;
    double at(double depth) const;
    double potential(double depth) const;
    double slope(double depth) const;
  };
  using Form = std::variant<Lines, Exponential, Analytic>;
  PressureLaw(double begin_gap, Form form) : begin_gap_(begin_gap), form_(std::move(form)) {}

  double begin_gap_;
  Form form_;
};

/// The law that a friction model names, times a factor; nothing when an error was added: neither PIECEWISE
/// LINEAR nor ANALYTIC, or it falls, is negative, never presses, or does not begin at 0. The warning
/// "pressure-function-flat" where a table ends level.
std::optional<PressureLaw> make_pressure_law(const DeckName& name, double factor,
                                             std::span<const FunctionDefinition> functions,
                                             Diagnostics& diagnostics);

}  // namespace contactsim
