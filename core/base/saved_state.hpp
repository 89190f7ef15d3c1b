// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace contactsim {

/// What the numbers of a saved array are.
enum class SavedType : std::uint8_t { real64, real32, uint64, uint32, uint8 };

/// Bytes of one number.
std::size_t size_of(SavedType type);

/// The type of a number in C++; defined for those of SavedType only.
template <class T>
inline constexpr SavedType saved_type = {};
template <>
inline constexpr SavedType saved_type<double> = SavedType::real64;
template <>
inline constexpr SavedType saved_type<float> = SavedType::real32;
template <>
inline constexpr SavedType saved_type<std::uint64_t> = SavedType::uint64;
template <>
inline constexpr SavedType saved_type<std::uint32_t> = SavedType::uint32;
template <>
inline constexpr SavedType saved_type<std::uint8_t> = SavedType::uint8;

/// Numbers under a name.
struct SavedArray {
  std::string name;  ///< groups and a name, divided by /
  SavedType type = SavedType::real64;
  std::span<const std::byte> bytes;  ///< as they are in memory, of whoever owns them

  std::size_t count() const { return bytes.size() / size_of(type); }
};

/// All that a run needs to go on from where it was: named arrays of numbers.
class SavedState {
 public:
  ///   origin  the file that it was read from, for messages
  explicit SavedState(std::string origin = "") : origin_(std::move(origin)) {}
  SavedState(SavedState&&) = default;
  SavedState& operator=(SavedState&&) = default;

  const std::string& origin() const { return origin_; }

  /// Adds numbers that stay where they are as long as this is used.
  template <class T>
  void add_view(std::string name, std::span<const T> values) {
    arrays_.push_back({std::move(name), saved_type<T>, std::as_bytes(values)});
  }
  /// Adds a copy of numbers.
  template <class T>
  void add_copy(const std::string& name, std::span<const T> values) {
    const std::span<std::byte> room = add_room(name, saved_type<T>, values.size());
    const std::span<const std::byte> bytes = std::as_bytes(values);
    std::copy(bytes.begin(), bytes.end(), room.begin());
  }
  /// Adds an array and returns where to put its numbers.
  std::span<std::byte> add_room(std::string name, SavedType type, std::size_t count);

  /// In the order in which they were added.
  std::span<const SavedArray> arrays() const { return arrays_; }
  /// The array of a name; null when there is none.
  const SavedArray* find(std::string_view name) const;

 private:
  std::string origin_;
  std::vector<SavedArray> arrays_;
  std::vector<std::vector<std::byte>> owned_;
};

/// A state of the same numbers, whoever owns those now.
SavedState copy_of(const SavedState& state);

}  // namespace contactsim
