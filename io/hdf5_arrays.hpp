// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/saved_state.hpp"

namespace contactsim {

/// Writes the arrays of a state to a new HDF5 file, each as a data set under its name. Throws FileError when
/// the system refuses.
///   named      the path for messages
///   head_size  bytes in front of what HDF5 writes, for others: 0, or a power of two from 512 on
void write_hdf5(const std::string& path, const std::string& named, std::size_t head_size,
                const SavedState& state);

/// Reads all arrays of an HDF5 file. Throws FileError when that is not possible. HDF5 is no judge of damaged
/// files: that this one is whole must be known.
SavedState read_hdf5(const std::string& path);

}  // namespace contactsim
