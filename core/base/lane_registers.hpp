// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

/// Numbers in the compiler's vectors, as many as 64 bytes hold: one register of AVX-512, two of AVX, four of
/// SSE.
namespace contactsim {

/// The widest vectors that the processor computes with [bytes]. GCC takes wider ones number by number where
/// it compares or chooses.
#if defined(__AVX512F__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

template <class Number>
struct RegisterOf {
  using Type [[gnu::vector_size(register_bytes)]] = Number;
};

/// 64 bytes of numbers, and what a function makes of each of their registers, or of those in the same place
/// of several.
#ifdef __AVX512F__
template <class Number>
using LaneRegisters = typename RegisterOf<Number>::Type;

template <class Made, class Function, class... Registers>
Made map_registers(const Function& f, const Registers&... of) {
  return f(of...);
}
#else
template <class Number>
struct LaneRegisters {
  static constexpr std::size_t n = 64 / register_bytes;
  typename RegisterOf<Number>::Type all[n];
};

template <class Made, class Function, class... Registers>
Made map_registers(const Function& f, const Registers&... of) {
  Made made;
  for (std::size_t k = 0; k < Made::n; ++k) made.all[k] = f(of.all[k]...);
  return made;
}
#endif

}  // namespace contactsim
