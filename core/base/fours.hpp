// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/tensor_lanes.hpp"

/// Vectors of four numbers, x y z and one more, and their components in lanes. One load takes a vector, and
/// eight of them make three Lanes by shuffles of registers alone, on every processor with AVX.
namespace contactsim {

/// The compiler's own vector, for shuffles that Eigen has no word for: a vector, or half of some Lanes.
using Four [[gnu::vector_size(4 * sizeof(double))]] = double;
using StoredFour [[gnu::vector_size(4 * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] =
    double;

inline Four load_four(const double* numbers) { return *reinterpret_cast<const StoredFour*>(numbers); }
inline void store_four(double* numbers, const Four& four) { *reinterpret_cast<StoredFour*>(numbers) = four; }

/// The first two numbers of each, and the last two.
inline Four first_halves(const Four& a, const Four& b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
inline Four last_halves(const Four& a, const Four& b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
/// The even numbers of both in turn, and the odd ones.
inline Four even_numbers(const Four& a, const Four& b) { return __builtin_shufflevector(a, b, 0, 4, 2, 6); }
inline Four odd_numbers(const Four& a, const Four& b) { return __builtin_shufflevector(a, b, 1, 5, 3, 7); }

/// Lanes of two halves.
inline Lanes joined(const Four& first, const Four& last) {
#ifdef __AVX512F__
  return Lanes(_mm512_insertf64x4(_mm512_castpd256_pd512(first), last, 1));
#else
  Lanes lanes;  // GCC takes vectors that are wider than registers number by number
  store_four(lanes.data(), first);
  store_four(lanes.data() + 4, last);
  return lanes;
#endif
}

/// Four vectors, component by component.
struct FourVectors {
  Four x, y, z;

  FourVectors(const double* a, const double* b, const double* c, const double* d) {
    const Four va = load_four(a), vb = load_four(b), vc = load_four(c), vd = load_four(d);
    const Four xz_ab = even_numbers(va, vb), y_ab = odd_numbers(va, vb);
    const Four xz_cd = even_numbers(vc, vd), y_cd = odd_numbers(vc, vd);
    x = first_halves(xz_ab, xz_cd);
    y = first_halves(y_ab, y_cd);
    z = last_halves(xz_ab, xz_cd);
  }
};

/// Eight vectors, component by component.
///   vector_of  where that of a lane stands
template <class VectorOf>
std::array<Lanes, 3> to_lanes(const VectorOf& vector_of) {
  const FourVectors first(vector_of(0), vector_of(1), vector_of(2), vector_of(3));
  const FourVectors last(vector_of(4), vector_of(5), vector_of(6), vector_of(7));
  return {joined(first.x, last.x), joined(first.y, last.y), joined(first.z, last.z)};
}

/// Four vectors of lanes from one on, their fourth numbers 0.
inline std::array<Four, 4> to_vectors(const Lanes& x, const Lanes& y, const Lanes& z, std::size_t first) {
  const Four x4 = load_four(x.data() + first), y4 = load_four(y.data() + first),
             z4 = load_four(z.data() + first), zero{};
  const Four xy_02 = even_numbers(x4, y4), xy_13 = odd_numbers(x4, y4);
  const Four z_02 = even_numbers(z4, zero), z_13 = odd_numbers(z4, zero);
  return {first_halves(xy_02, z_02), first_halves(xy_13, z_13), last_halves(xy_02, z_02),
          last_halves(xy_13, z_13)};
}

}  // namespace contactsim
