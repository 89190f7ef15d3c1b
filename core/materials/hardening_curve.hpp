// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/base/lanes.hpp"
#include "core/definition/function.hpp"
#include "core/functions/piecewise.hpp"

namespace contactsim {

/// A flow stress over the equivalent plastic strain: straight lines between points, constant after the last.
class HardeningCurve {
 public:
  /// A point, and the slope from it to the next.
  struct Point {
    double strain, stress, slope;
  };

  /// Points of the curve, one a lane.
  struct Place {
    Lanes strain;      ///< [1]
    Lanes stress;      ///< there [force/length^2]
    Lanes slope;       ///< of the line on from there [force/length^2]
    std::size_t next;  ///< the first point that some lane has not passed
  };

  HardeningCurve() = default;
  ///   points  at least one, the first at 0; strain strictly increasing, stress positive and not decreasing
  explicit HardeningCurve(std::span<const FunctionPoint> points);

  double first_stress() const { return points_.front().stress; }
  std::span<const Point> points() const { return points_; }

  /// The curve at plastic strains that are not negative.
  Place at(const Lanes& strain) const;

  /// Where lanes stand that go up the curve from point to point as long as is_reached(point), a LaneMask
  /// which once false stays so. Lanes that reach no point stay at the start.
  template <class IsReached>
  Place climb(const Place& start, const IsReached& is_reached) const {
    Place place = start;
    for (std::size_t i = start.next; i < points_.size(); ++i) {
      const LaneMask is_passed = points_[i].strain <= start.strain, is_now = is_reached(points_[i]);
      if (!(is_passed || is_now).any()) break;
      const LaneMask moves = is_now && !is_passed;
      place.strain = moves.select(points_[i].strain, place.strain);
      place.stress = moves.select(points_[i].stress, place.stress);
      place.slope = moves.select(points_[i].slope, place.slope);
    }
    return place;
  }

 private:
  std::vector<Point> points_{{0.0, 0.0, 0.0}};
};

/// The curve of HARDENING FUNCTION. It is what hardening adds to the yield stress when it begins at 0, or the
/// flow stress itself when it begins at the yield stress. Nothing when an error was added: an unknown
/// function, one that is not PIECEWISE LINEAR, that begins elsewhere, or that falls.
/// Source: the LAME manual of Sierra/SM 5.22, MULTILINEAR_EP, has the flow stress piecewise linear over the
/// plastic strain; whether decks write it with the yield stress (as the published ones of MatCal do for
/// J2_PLASTICITY) or without, the first point tells.
///   yield_stress  > 0 [force/length^2]
std::optional<HardeningCurve> make_hardening_curve(const DeckName& name, double yield_stress,
                                                   std::span<const FunctionDefinition> functions,
                                                   Diagnostics& diagnostics);

}  // namespace contactsim
