// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/restart/restart_file.hpp"

/// A restart database is a set of files, one for each state: <name>.1, <name>.2, ... and of the run that goes
/// on from one of them <name>-s0002.1, ...
namespace contactsim {

/// What the files of a run that goes on have at the end of their names, so that none of an earlier run is
/// overwritten: "" for the first, then -s0002, -s0003, ... Source: the names of Sierra's output files.
std::string run_suffix(std::int64_t run);

/// The file of a state.
///   slot  from 1
std::string restart_path(const std::string& database, std::int64_t run, std::int64_t slot);
/// Whether a path is that of a state of a database, in some run and slot.
bool is_restart_path(const std::string& database, const std::string& path);

/// A state of a database.
struct StoredState {
  std::string path;
  RestartHead head;
};

/// The states of a database whose heads can be read, the latest first: of what began last the latest run, and
/// of that the latest step.
///   unusable  gains what is wrong with the others
std::vector<StoredState> find_stored_states(const std::string& database, std::vector<std::string>& unusable);

/// Says to which slots the states of a run go. Source: Sierra/SM 5.22, 9.9, overlay count and cycle count.
class RestartSlots {
 public:
  ///   overlay_count  a slot is overwritten so many times before the next is begun, >= 0
  ///   cycle_count    slots before the first is used again, >= 1; absent: there is no end
  RestartSlots(std::int64_t overlay_count, std::optional<std::int64_t> cycle_count)
      : overlay_count_(overlay_count), cycle_count_(cycle_count) {}

  /// The slot of the next state, from 1.
  std::int64_t take();

 private:
  std::int64_t overlay_count_;
  std::optional<std::int64_t> cycle_count_;
  std::int64_t n_taken_ = 0;
};

}  // namespace contactsim
