// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <cstring>

/// Numbers of eight elements at a time, in the compiler's vectors: one register of AVX-512, two of AVX, four
/// of SSE. Members have the names that Eigen's arrays give them. Sums, products, quotients and square roots
/// are IEEE's on every processor; other functions are Eigen's.
namespace contactsim {

/// Element kernels and material laws work on this many elements at a time, one per lane.
inline constexpr int n_lanes = 8;

class Lanes;

/// Which elements something holds for.
class LaneMask {
 public:
  /// All bits of a lane, or none.
  using Vector [[gnu::vector_size(n_lanes * sizeof(double))]] = std::int64_t;

  LaneMask() = default;
  LaneMask(const Vector& lanes) : lanes_(lanes) {}
  explicit LaneMask(bool holds) : lanes_(Vector{} - (holds ? 1 : 0)) {}
  /// From the lowest bits, one of each lane.
  static LaneMask of_bits(unsigned bits) {
    constexpr Vector places{1, 2, 4, 8, 16, 32, 64, 128};
    return {((Vector{} + bits) & places) != 0};
  }

  friend LaneMask operator&&(const LaneMask& a, const LaneMask& b) { return {a.lanes_ & b.lanes_}; }
  friend LaneMask operator||(const LaneMask& a, const LaneMask& b) { return {a.lanes_ | b.lanes_}; }
  friend LaneMask operator!(const LaneMask& a) { return {~a.lanes_}; }
  bool operator()(Eigen::Index lane) const { return lanes_[lane] != 0; }
  bool any() const { return bytes() != 0; }
  bool all() const { return bytes() == ~std::uint64_t{0}; }
  /// The one where it holds, the other elsewhere.
  Lanes select(const Lanes& where_it_holds, const Lanes& elsewhere) const;

 private:
  using Bytes [[gnu::vector_size(n_lanes)]] = std::int8_t;
  std::uint64_t bytes() const { return std::bit_cast<std::uint64_t>(__builtin_convertvector(lanes_, Bytes)); }

  Vector lanes_;
};

/// One number of each element.
class Lanes {
 public:
  using Vector [[gnu::vector_size(n_lanes * sizeof(double))]] = double;
  using EigenArray = Eigen::Array<double, n_lanes, 1>;

  Lanes() = default;
  Lanes(double a) : lanes_{a, a, a, a, a, a, a, a} {}
  Lanes(const Vector& lanes) : lanes_(lanes) {}
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
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return {a.lanes_ + b.lanes_}; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return {a.lanes_ - b.lanes_}; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return {a.lanes_ * b.lanes_}; }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return {a.lanes_ / b.lanes_}; }
  friend Lanes operator-(const Lanes& a) { return {-a.lanes_}; }
  friend LaneMask operator<(const Lanes& a, const Lanes& b) { return {a.lanes_ < b.lanes_}; }
  friend LaneMask operator>(const Lanes& a, const Lanes& b) { return {a.lanes_ > b.lanes_}; }
  friend LaneMask operator<=(const Lanes& a, const Lanes& b) { return {a.lanes_ <= b.lanes_}; }
  friend LaneMask operator>=(const Lanes& a, const Lanes& b) { return {a.lanes_ >= b.lanes_}; }
  friend LaneMask operator==(const Lanes& a, const Lanes& b) { return {a.lanes_ == b.lanes_}; }
  friend LaneMask operator!=(const Lanes& a, const Lanes& b) { return {a.lanes_ != b.lanes_}; }

  /// As std::min and std::max: this one where neither is less.
  Lanes min(const Lanes& b) const { return {b.lanes_ < lanes_ ? b.lanes_ : lanes_}; }
  Lanes max(const Lanes& b) const { return {lanes_ < b.lanes_ ? b.lanes_ : lanes_}; }
  Lanes abs() const { return eigen().abs(); }
  Lanes sqrt() const {
#ifdef __AVX512F__
    return {_mm512_sqrt_pd(lanes_)};  // Eigen's is an approximation there
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

  double operator()(Eigen::Index lane) const { return lanes_[lane]; }
  double& operator()(Eigen::Index lane) { return data()[lane]; }
  double* data() { return reinterpret_cast<double*>(&lanes_); }
  const double* data() const { return reinterpret_cast<const double*>(&lanes_); }
  /// The same numbers for what is not here.
  Eigen::Map<const EigenArray, Eigen::Aligned64> eigen() const {
    return Eigen::Map<const EigenArray, Eigen::Aligned64>(data());
  }
  const Vector& vector() const { return lanes_; }

 private:
  Vector lanes_;
};

inline Lanes LaneMask::select(const Lanes& where_it_holds, const Lanes& elsewhere) const {
  return {lanes_ ? where_it_holds.vector() : elsewhere.vector()};
}

/// The lanes before one.
inline LaneMask first_lanes(std::size_t n) { return LaneMask::of_bits((1u << n) - 1u); }

}  // namespace contactsim
