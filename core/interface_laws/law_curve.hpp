// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/function.hpp"
#include "core/functions/piecewise.hpp"

namespace contactsim {

/// The piecewise linear function of a friction model, times its factor: a force or traction over a gap or a
/// slip. It has an end, which laws need: their pull ends there, or they fail.
class LawCurve {
 public:
  ///   points  at least one, x strictly increasing
  explicit LawCurve(std::vector<FunctionPoint> points) : points_(std::move(points)), line_(points_) {}

  double at(double x) const { return line_.evaluate(x); }
  /// From 0 to x >= 0, exactly [ordinate times abscissa].
  double integral(double x) const;
  double last() const { return points_.back().x; }
  /// The largest slope either way; 0 of a single point [ordinate over abscissa].
  double steepest() const;
  /// Whether the ordinate over the abscissa never rises for x > 0 and no ordinate is negative there.
  bool softens() const;

 private:
  std::vector<FunctionPoint> points_;
  PiecewiseLinear line_;
};

/// The curve that a friction model names, times a factor; nothing when an error was added: unknown, not
/// PIECEWISE LINEAR, or wrong by itself.
std::optional<LawCurve> make_law_curve(const DeckName& name, double scale,
                                       std::span<const FunctionDefinition> functions,
                                       Diagnostics& diagnostics);

}  // namespace contactsim
