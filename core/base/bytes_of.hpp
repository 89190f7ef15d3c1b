// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace contactsim {

/// The memory of a list, without what its items point to [bytes].
template <class T, class Allocator>
std::size_t bytes_of(const std::vector<T, Allocator>& list) {
  return list.capacity() * sizeof(T);
}

}  // namespace contactsim
