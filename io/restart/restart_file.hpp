// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "core/base/saved_state.hpp"

namespace contactsim {

/// What a restart file says about its state.
struct RestartHead {
  std::int64_t begun = 0;  ///< when the run from the start began, by the clock, since 1970 [ns]
  std::int64_t run = 1;    ///< 1 of the run from the start, 2 of the first that went on, ...
  std::int64_t step = 0;
  double time = 0.0;  ///< [time]
};

/// Writes a state to an HDF5 file: under a temporary name, down to the disk, then renamed, so that a file of
/// the name is whole whenever the process or the machine stops. It begins with 512 bytes of text: the head
/// and a checksum of everything else. Throws FileError.
void write_restart_file(const std::string& path, const RestartHead& head, const SavedState& state);

/// Reads the head alone. Throws FileError when there is none; the rest may be damaged all the same.
RestartHead read_restart_head(const std::string& path);

/// Reads a state. Throws FileError when the file is not, to the last bit, what was written.
SavedState read_restart_file(const std::string& path);

}  // namespace contactsim
