// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/state_archive.hpp"

#include <fmt/format.h>

#include "core/base/errors.hpp"

namespace contactsim {

void StateArchive::expect(const std::string& name, std::uint64_t number, const std::string& what) {
  if (!restores()) return saved_.add_copy(name, std::span<const std::uint64_t>(&number, 1));
  const std::span<const std::uint64_t> stored = find<std::uint64_t>(name);
  if (stored.size() == 1 && stored.front() == number) return;
  throw FileError(from_->origin(), fmt::format("is of a run with other {} ({} is not the same)", what, name));
}

void StateArchive::optional(const std::string& name, std::optional<std::int64_t>& number) {
  bool is_there = number.has_value();
  std::int64_t value = number.value_or(0);
  numbers(name, is_there, value);
  number = is_there ? std::optional(value) : std::nullopt;
}

void StateArchive::set(const std::string& name, std::set<std::uint64_t>& values) {
  std::vector<std::uint64_t> ascending(values.begin(), values.end());
  if (!restores()) return saved_.add_copy(name, std::span<const std::uint64_t>(ascending));
  list(name, ascending);
  values = {ascending.begin(), ascending.end()};
}

std::span<const std::byte> StateArchive::find_bytes(const std::string& name, SavedType type) const {
  const SavedArray* array = from_->find(name);
  if (array == nullptr)
    throw FileError(from_->origin(), fmt::format("does not fit the run: it holds no {}", name));
  if (array->type != type)
    throw FileError(from_->origin(), fmt::format("does not fit the run: {} is of another type", name));
  return array->bytes;
}

void StateArchive::fail_size(const std::string& name, std::size_t found, std::size_t wanted) const {
  throw FileError(from_->origin(),
                  fmt::format("does not fit the run: {} has {} numbers, {} are needed", name, found, wanted));
}

}  // namespace contactsim
