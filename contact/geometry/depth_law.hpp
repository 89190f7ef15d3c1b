// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/lanes.hpp"

namespace contactsim {

/// How the pressure of the elastic penalty grows with the depth d of penetration: p = k f(d). Up to d0 it is
/// a spring, f = d; from there to d1 its slope grows to that of a spring so many times as stiff, which it
/// keeps:
///   f' = 1 + s e,   e = d - d0 within [0, d1 - d0]
/// A function of the depth alone stores what work is done on it. Without it, a spring that the masses and the
/// step can bear at touch lets whatever presses or hits hard enough pass through a wall or an element.
/// Source: nonlinear (exponential, piecewise linear) pressure-overclosure of Abaqus; Wriggers, Computational
/// Contact Mechanics (2006), 5.1, for constitutive interface laws.
///   Number  double, or Lanes for laws of eight pairs
template <class Number>
class DepthLawOf {
 public:
  /// A spring at all depths.
  DepthLawOf() = default;
  ///   begin, end  d0 < d1 [length]
  ///   stiffest    slope from d1 on, >= 1 [1]
  DepthLawOf(double begin, double end, double stiffest)
      : begin_(begin), width_(end - begin), growth_((stiffest - 1.0) / width_) {}

  /// Takes a law over to a lane.
  void set(Eigen::Index lane, const DepthLawOf<double>& law) {
    begin_(lane) = law.begin_;
    width_(lane) = law.width_;
    growth_(lane) = law.growth_;
  }

  /// The law that is a spring for so much longer, >= 0 [length].
  DepthLawOf behind(double depth) const {
    DepthLawOf law = *this;
    law.begin_ += depth;
    return law;
  }

  /// f: the depth at which a spring would press as much [length].
  template <class Depth>
  Depth spring_depth(const Depth& depth) const {
    const auto [e, beyond] = parts(depth);
    return depth + growth_ * (0.5 * e * e + width_ * beyond);
  }
  /// The integral of f: the stored energy per area and stiffness [length^2].
  template <class Depth>
  Depth potential(const Depth& depth) const {
    const auto [e, beyond] = parts(depth);
    return 0.5 * depth * depth + growth_ * (e * e * e / 6.0 + 0.5 * width_ * beyond * (width_ + beyond));
  }
  /// f' [1].
  double slope(double depth) const { return 1.0 + growth_ * std::clamp(depth - begin_, 0.0, width_); }

 private:
  template <class>
  friend class DepthLawOf;
  /// e and what is deeper than d1.
  std::array<Lanes, 2> parts(const Lanes& depth) const {
    return {(depth - begin_).max(0.0).min(width_), (depth - begin_ - width_).max(0.0)};
  }
  std::array<double, 2> parts(double depth) const {
    return {std::clamp(depth - begin_, 0.0, width_), std::max(depth - begin_ - width_, 0.0)};
  }

  Number begin_ = std::numeric_limits<double>::infinity();  // d0 [length]
  Number width_ = 0.0;                                      // d1 - d0 [length]
  Number growth_ = 0.0;                                     // s [1/length]
};

using DepthLaw = DepthLawOf<double>;
using DepthLaws = DepthLawOf<Lanes>;

}  // namespace contactsim
