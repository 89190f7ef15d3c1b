// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/saved_state.hpp"

namespace contactsim {

/// The arrays of a state as the bytes of an HDF5 file, each a data set under its name. They are made in
/// memory: HDF5 does not bear that a disk is full.
class Hdf5Image {
 public:
  /// Throws std::bad_alloc.
  ///   head_size  bytes in front of what HDF5 writes, for others: 0, or a power of two from 512 on
  Hdf5Image(std::size_t head_size, const SavedState& state);
  ~Hdf5Image();
  Hdf5Image(const Hdf5Image&) = delete;
  Hdf5Image& operator=(const Hdf5Image&) = delete;

  std::span<std::byte> bytes() { return bytes_; }

 private:
  std::int64_t file_;  // as HDF5 numbers it
  std::span<std::byte> bytes_;
};

/// Reads all arrays of an HDF5 file. Throws FileError when that is not possible. HDF5 is no judge of damaged
/// files: that this one is whole must be known.
SavedState read_hdf5(const std::string& path);

}  // namespace contactsim
