// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/reduction.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace contactsim {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Whether a is beyond b, or is the first that is not a number.
template <class Compare>
double extreme(double a, double b, Compare is_beyond) {
  return std::isnan(a) || is_beyond(a, b) ? a : b;
}

// One component's values, one after another.
class Accumulator {
 public:
  void add(double value) {
    ++n_;
    sum_ += value;
    sum_of_squares_ += value * value;
    const double n = static_cast<double>(n_), from_mean = value - mean_;
    mean_ += from_mean / n;
    squared_distances_ += from_mean * (value - mean_);
    if (n_ == 1) greatest_ = least_ = value;
    greatest_ = extreme(value, greatest_, std::greater<>());
    least_ = extreme(value, least_, std::less<>());
  }

  double result(OutputReduction reduction) const {
    const auto n = static_cast<double>(n_);
    switch (reduction) {
      case OutputReduction::sum:
        return sum_;
      case OutputReduction::l2_norm:
        return std::sqrt(sum_of_squares_);
      case OutputReduction::maximum:
        return greatest_;
      case OutputReduction::minimum:
        return least_;
      case OutputReduction::absolute_maximum:
        return extreme(std::abs(greatest_), std::abs(least_), std::greater<>());
      case OutputReduction::average:
        return n_ == 0 ? nan : sum_ / n;
      case OutputReduction::variance:
        break;
    }
    return n_ == 0 ? nan : squared_distances_ / n;
  }

 private:
  std::size_t n_ = 0;
  double sum_ = 0.0, sum_of_squares_ = 0.0;
  // Source: Welford, Technometrics 4 (1962) 419-420.
  double mean_ = 0.0, squared_distances_ = 0.0;
  double greatest_ = nan, least_ = nan;
};

}  // namespace

std::vector<double> reduce(OutputReduction reduction, const VariableSelection& selection,
                           std::span<const EntityRange> ranges, const OutputContext& context) {
  std::vector<Accumulator> components(selection.n_components());
  visit_values(selection, ranges, context, [&](const EntityRange&, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) components[i % components.size()].add(values[i]);
  });
  std::vector<double> results;
  for (const Accumulator& component : components) results.push_back(component.result(reduction));
  return results;
}

}  // namespace contactsim
