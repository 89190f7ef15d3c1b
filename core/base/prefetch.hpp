// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace contactsim {

/// Has the memory of an object fetched into the caches, while something else is done. Inlined always: a
/// function that does nothing but fetch has no effect that a compiler knows of, and its calls are left out.
template <class T>
[[gnu::always_inline]] inline void prefetch(const T& object) {
  constexpr std::size_t cache_line = 64;
  const char* begin = reinterpret_cast<const char*>(&object);
  for (std::size_t i = 0; i < sizeof(T); i += cache_line) __builtin_prefetch(begin + i);
  if constexpr (alignof(T) < cache_line) __builtin_prefetch(begin + sizeof(T) - 1);
}

}  // namespace contactsim
