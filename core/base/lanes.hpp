// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include <Eigen/Core>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/lane_arithmetic.hpp"

/// Numbers of eight elements at a time. Members have the names that Eigen's arrays give them. Sums, products,
/// quotients and square roots are IEEE's on every processor; other functions are Eigen's.
namespace contactsim {

/// Element kernels and material laws work on this many elements at a time, one per lane.
inline constexpr int n_lanes = 8;

/// One number of each element.
class Lanes : public LaneArithmetic<Lanes, double> {
 public:
  using EigenArray = Eigen::Array<double, n_lanes, 1>;

  Lanes() = default;
  Lanes(double a) : LaneArithmetic(a) {}
  Lanes(const Registers& lanes) : LaneArithmetic(lanes) {}
  explicit Lanes(const Numbers& numbers) : LaneArithmetic(std::bit_cast<Registers>(numbers)) {}
  template <class Derived>
  Lanes(const Eigen::ArrayBase<Derived>& array) {
    const EigenArray numbers = array;
    std::memcpy(&lanes_, numbers.data(), sizeof lanes_);
  }
  static Lanes Zero() { return 0.0; }
  static Lanes Ones() { return 1.0; }
  static Lanes Constant(double number) { return number; }
  void setZero() { *this = 0.0; }
  void setConstant(double number) { *this = number; }

  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  Lanes& operator/=(const Lanes& b) { return *this = *this / b; }
  Lanes abs() const { return eigen().abs(); }
  Lanes sqrt() const {
#ifdef __AVX512F__
    return map([](const auto& x) { return _mm512_sqrt_pd(x); }, *this);  // Eigen's is an approximation there
#else
    return eigen().sqrt();
#endif
  }
  Lanes exp() const { return eigen().exp(); }
  Lanes log() const { return eigen().log(); }
  Lanes cos() const { return eigen().cos(); }
  Lanes acos() const { return eigen().acos(); }
  /// Of what is not negative, off by some 2e-16 (1 + |exponent log|) of the power.
  Lanes pow(double exponent) const { return (exponent * log()).exp(); }
  double sum() const {
    const Lanes& a = *this;
    return ((a(0) + a(4)) + (a(1) + a(5))) + ((a(2) + a(6)) + (a(3) + a(7)));
  }
  /// Of the first n.
  double sum_of_first(std::size_t n) const {
    if (n == n_lanes) return sum();
    double sum = 0.0;
    for (std::size_t lane = 0; lane < n; ++lane) sum += data()[lane];
    return sum;
  }
  double minCoeff() const { return eigen().minCoeff(); }
  double maxCoeff() const { return eigen().maxCoeff(); }

  double operator()(Eigen::Index lane) const { return data()[lane]; }
  double& operator()(Eigen::Index lane) { return data()[lane]; }
  double* data() { return reinterpret_cast<double*>(&lanes_); }
  const double* data() const { return reinterpret_cast<const double*>(&lanes_); }
  /// The same numbers for what is not here.
  Eigen::Map<const EigenArray, Eigen::Aligned64> eigen() const {
    return Eigen::Map<const EigenArray, Eigen::Aligned64>(data());
  }
};

/// Which elements something holds for.
using LaneMask = Lanes::Mask;

/// The lanes before one.
inline LaneMask first_lanes(std::size_t n) { return LaneMask::of_bits((1u << n) - 1u); }

}  // namespace contactsim
