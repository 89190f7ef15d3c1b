// SPDX-License-Identifier: BSD-3-Clause
#include "io/restart/restart_database.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <tuple>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

std::string_view skip_digits(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  return end == std::string_view::npos ? "" : text.substr(end);
}

/// Whether a file of this name is of the database: its name, perhaps -s and a number, a dot and a number.
bool is_of(std::string_view database, std::string_view file) {
  if (!file.starts_with(database)) return false;
  file.remove_prefix(database.size());
  constexpr std::string_view run = "-s";
  if (file.starts_with(run)) file = skip_digits(file.substr(run.size()));
  return file.size() > 1 && file.front() == '.' && skip_digits(file.substr(1)).empty();
}

bool is_later(const StoredState& one, const StoredState& other) {
  const auto key = [](const StoredState& state) {
    return std::tuple(-state.head.begun, -state.head.run, -state.head.step, std::string_view(state.path));
  };
  return key(one) < key(other);
}

}  // namespace

bool is_restart_path(const std::string& database, const std::string& path) {
  return is_of(fs::path(database).lexically_normal().string(), fs::path(path).lexically_normal().string());
}

std::string run_suffix(std::int64_t run) { return run == 1 ? "" : fmt::format("-s{:04}", run); }

std::string restart_path(const std::string& database, std::int64_t run, std::int64_t slot) {
  return fmt::format("{}{}.{}", database, run_suffix(run), slot);
}

std::vector<StoredState> find_stored_states(const std::string& database, std::vector<std::string>& unusable) {
  const fs::path folder = fs::path(database).parent_path();
  const std::string name = fs::path(database).filename().string();
  std::vector<StoredState> states;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string file = entry.path().filename().string();
    if (!is_of(name, file) || !entry.is_regular_file(error)) continue;
    const std::string path = (folder / file).string();
    try {
      states.push_back({path, read_restart_head(path)});
    } catch (const FileError& problem) {
      unusable.emplace_back(problem.what());
    }
  }
  std::ranges::sort(states, is_later);
  std::ranges::sort(unusable);
  return states;
}

std::int64_t RestartSlots::take() {
  const std::int64_t slot = n_taken_++ / (overlay_count_ + 1);
  return 1 + (cycle_count_ ? slot % *cycle_count_ : slot);
}

}  // namespace contactsim
