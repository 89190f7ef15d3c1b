// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/saved_state.hpp"

#include <algorithm>
#include <array>

namespace contactsim {

std::size_t size_of(SavedType type) {
  constexpr std::array<std::size_t, 5> sizes{8, 4, 8, 4, 1};
  return sizes[static_cast<std::size_t>(type)];
}

std::span<std::byte> SavedState::add_room(std::string name, SavedType type, std::size_t count) {
  std::vector<std::byte>& room = owned_.emplace_back(count * size_of(type));
  arrays_.push_back({std::move(name), type, room});
  return room;
}

const SavedArray* SavedState::find(std::string_view name) const {
  const auto found = std::ranges::find(arrays_, name, &SavedArray::name);
  return found == arrays_.end() ? nullptr : &*found;
}

SavedState copy_of(const SavedState& state) {
  SavedState copy(state.origin());
  for (const SavedArray& array : state.arrays()) {
    const std::span<std::byte> room = copy.add_room(array.name, array.type, array.count());
    std::ranges::copy(array.bytes, room.begin());
  }
  return copy;
}

}  // namespace contactsim
