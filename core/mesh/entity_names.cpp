// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/entity_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

struct KindWords {
  std::string_view title;
  std::string_view prefix;
  std::string_view other_prefix;
};

constexpr std::array<KindWords, n_entity_kinds> words{{
    {"block", "block_", "block_"},
    {"side set", "surface_", "sideset_"},
    {"node set", "nodelist_", "nodeset_"},
    {"assembly", "assembly_", "assembly_"},
}};

const KindWords& words_of(EntityKind kind) { return words[static_cast<std::size_t>(kind)]; }

// "007" is not how a default name writes 7, so block_007 stays a name like any other.
std::optional<std::int64_t> parse_id(std::string_view digits) {
  if (digits.empty() || digits.front() == '-' || (digits.front() == '0' && digits.size() > 1)) {
    return std::nullopt;
  }
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return id;
}

}  // namespace

std::string_view to_string(EntityKind kind) { return words_of(kind).title; }

std::string default_name(EntityKind kind, std::int64_t id) {
  return fmt::format("{}{}", words_of(kind).prefix, id);
}

std::optional<std::int64_t> find_default_id(EntityKind kind, std::string_view name) {
  const std::string folded = fold(name);
  for (std::string_view prefix : {words_of(kind).prefix, words_of(kind).other_prefix}) {
    if (folded.starts_with(prefix)) return parse_id(std::string_view(folded).substr(prefix.size()));
  }
  return std::nullopt;
}

std::string effective_name(EntityKind kind, std::string_view stored, std::int64_t id) {
  const bool is_of_another = find_default_id(kind, stored).value_or(id) != id;
  return stored.empty() || is_of_another ? default_name(kind, id) : std::string(stored);
}

EntityLookup::EntityLookup(EntityKind kind, std::vector<std::int64_t> ids,
                           const std::vector<std::string>& stored_names)
    : kind_(kind), ids_(std::move(ids)), by_id_(ids_) {
  assert(ids_.size() == stored_names.size());
  for (std::uint32_t i = 0; i < ids_.size(); ++i) {
    by_name_.emplace_back(fold(effective_name(kind_, stored_names[i], ids_[i])), i);
  }
  std::sort(by_name_.begin(), by_name_.end());
}

std::optional<std::uint32_t> EntityLookup::find(std::string_view name) const {
  if (const auto id = find_default_id(kind_, name)) return by_id_.find(ids_, *id);
  const std::string folded = fold(name);
  const auto found =
      std::lower_bound(by_name_.begin(), by_name_.end(), folded,
                       [](const auto& row, const std::string& key) { return row.first < key; });
  if (found == by_name_.end() || found->first != folded) return std::nullopt;
  return found->second;
}

}  // namespace contactsim
