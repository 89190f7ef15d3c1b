// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <type_traits>
#include <vector>

#include "core/base/row_numbers.hpp"
#include "core/base/saved_state.hpp"

namespace contactsim {

/// A state that is saved, or restored from what was saved. Whoever has a memory lists it in one function for
/// both ways, so that the two cannot disagree. Restoring throws FileError naming the file when something is
/// missing or has another size.
class StateArchive {
 public:
  /// Saves.
  StateArchive() = default;
  /// Restores. The saved state must outlive this.
  explicit StateArchive(const SavedState& from) : from_(&from) {}

  bool restores() const { return from_ != nullptr; }
  /// Whether an array can be given: when saving always.
  bool has(const std::string& name) const { return !restores() || from_->find(name) != nullptr; }
  /// What has been saved. Arrays given to fixed() and list() must stay as they are while it is used.
  SavedState take() { return std::move(saved_); }

  /// A number that has to be the same in a run that goes on.
  ///   what  differs else: "the mesh"
  void expect(const std::string& name, std::uint64_t number, const std::string& what);

  /// Numbers whose count never changes in a run.
  template <class T>
  void fixed(const std::string& name, std::span<T> values) {
    if (!restores()) return saved_.add_view(name, std::span<const T>(values));
    const std::span<const T> stored = find<T>(name);
    if (stored.size() != values.size()) fail_size(name, stored.size(), values.size());
    std::ranges::copy(stored, values.begin());
  }
  void fixed(const std::string& name, Eigen::Matrix3Xd& values) {
    fixed(name, std::span(values.data(), static_cast<std::size_t>(values.size())));
  }

  /// Numbers, or vectors of a fixed size, that come and go.
  template <class T>
  void list(const std::string& name, std::vector<T>& values) {
    using Number = typename NumberOf<T>::Type;
    constexpr std::size_t n = NumberOf<T>::count;
    const auto numbers = [&] {
      return std::span(reinterpret_cast<Number*>(values.data()), n * values.size());
    };
    if (restores()) values.resize(find<Number>(name).size() / n);
    fixed<Number>(name, numbers());
  }

  /// Structs that come and go.
  ///   visit(item, row)  gives the members of one to the row
  template <class T, class Visit>
  void rows(const std::string& name, std::vector<T>& items, const Visit& visit) {
    std::vector<double> row;
    RowNumbers to(row);
    if (!restores()) {
      for (T& item : items) visit(item, to);
      return saved_.add_copy(name, std::span<const double>(row));
    }
    T sample{};
    visit(sample, to);
    const std::span<const double> stored = find<double>(name);
    if (stored.size() % row.size() != 0) fail_size(name, stored.size(), row.size());
    items.resize(stored.size() / row.size(), sample);
    RowNumbers from(stored);
    for (T& item : items) visit(item, from);
  }
  /// The same of structs whose count never changes in a run.
  template <class T, class Visit>
  void fixed_rows(const std::string& name, std::vector<T>& items, const Visit& visit) {
    const std::size_t n = items.size();
    rows(name, items, visit);
    if (items.size() != n) fail_size(name, items.size(), n);
  }

  /// Some numbers of all kinds under one name.
  template <class... Members>
  void numbers(const std::string& name, Members&... members) {
    std::vector<double> row;
    RowNumbers to(row);
    to(members...);
    if (!restores()) return saved_.add_copy(name, std::span<const double>(row));
    const std::span<const double> stored = find<double>(name);
    if (stored.size() != row.size()) fail_size(name, stored.size(), row.size());
    RowNumbers from(stored);
    from(members...);
  }
  /// A whole number that may not be there.
  void optional(const std::string& name, std::optional<std::int64_t>& number);
  void set(const std::string& name, std::set<std::uint64_t>& values);

 private:
  /// The numbers that a value is made of.
  template <class T>
  struct NumberOf {
    using Type = typename T::Scalar;
    static constexpr std::size_t count = sizeof(T) / sizeof(Type);
  };
  template <class T>
  requires std::is_arithmetic_v<T>
  struct NumberOf<T> {
    using Type = T;
    static constexpr std::size_t count = 1;
  };

  std::span<const std::byte> find_bytes(const std::string& name, SavedType type) const;
  template <class T>
  std::span<const T> find(const std::string& name) const {
    const std::span<const std::byte> bytes = find_bytes(name, saved_type<T>);
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
  }
  [[noreturn]] void fail_size(const std::string& name, std::size_t found, std::size_t wanted) const;

  const SavedState* from_ = nullptr;  // null: saves
  SavedState saved_;
};

}  // namespace contactsim
