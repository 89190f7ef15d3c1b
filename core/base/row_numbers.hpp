// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/index.hpp"

namespace contactsim {

/// The numbers of one struct on their way to a row of doubles or back, so that its members are listed once:
///   [](Spring& spring, RowNumbers& row) { row(spring.nodes, spring.force, spring.is_cut); }
/// Whole numbers must be below 2^53.
class RowNumbers {
 public:
  /// Appends to a row.
  explicit RowNumbers(std::vector<double>& to) : to_(&to) {}
  /// Takes from a row, which must be long enough.
  explicit RowNumbers(std::span<const double> from) : from_(from) {}

  template <class... Members>
  void operator()(Members&... members) {
    (pass(members), ...);
  }

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void pass(T& number) {
    if (to_ != nullptr) {
      to_->push_back(static_cast<double>(number));
      return;
    }
    number = static_cast<T>(from_.front());
    from_ = from_.subspan(1);
  }
  template <class Kind>
  void pass(Index<Kind>& position) {
    pass(position.value);
  }
  template <class Derived>
  void pass(Eigen::PlainObjectBase<Derived>& numbers) {
    for (Eigen::Index i = 0; i < numbers.size(); ++i) pass(numbers.data()[i]);
  }
  template <class T, std::size_t n>
  void pass(std::array<T, n>& numbers) {
    for (T& number : numbers) pass(number);
  }

  std::vector<double>* to_ = nullptr;
  std::span<const double> from_;
};

}  // namespace contactsim
