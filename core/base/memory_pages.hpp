// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace contactsim {

/// Sets numbers to zero and gives the pages that they fill back to the system: what stays zero takes no
/// memory, and what reads it reads one page of zeros. Where the system does not do so they are just set.
///   values  on the heap
void set_zero_without_memory(std::span<double> values);

inline void set_zero_without_memory(Eigen::Matrix3Xd& values) {
  set_zero_without_memory({values.data(), static_cast<std::size_t>(values.size())});
}

/// Asks the system to have an array in huge pages, so that addresses are looked up less often where all of it
/// is walked through or picked from in each step. To be called before its first use; a system that has none
/// to give leaves it as it is.
///   bytes  on the heap
void prefer_huge_pages(std::span<std::byte> bytes);

/// Gives a matrix its columns, whose numbers are unknown then, in huge pages if there are any.
inline void resize_in_huge_pages(Eigen::Index n_columns, Eigen::Matrix3Xd& values) {
  values.resize(3, n_columns);
  prefer_huge_pages(
      std::as_writable_bytes(std::span(values.data(), static_cast<std::size_t>(values.size()))));
}

/// Gives a vector n equal items, in huge pages if there are any.
template <class Item>
void assign_in_huge_pages(std::size_t n, const Item& item, std::vector<Item>& items) {
  items = {};
  items.reserve(n);
  prefer_huge_pages(std::as_writable_bytes(std::span(items.data(), n)));
  items.assign(n, item);
}

/// Gives back what has been freed and no later array has taken.
void return_freed_memory();

}  // namespace contactsim
