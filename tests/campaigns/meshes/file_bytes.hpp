// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace contactsim::test {

/// A number in the header of a classic netCDF file: a tag, a count, a length, a type, a position.
struct HeaderField {
  std::size_t begin = 0;
  std::size_t n_bytes = 4;
};

/// Those of a whole file, as far as the header can be followed.
/// Source: netCDF User's Guide, appendix B.
std::vector<HeaderField> find_classic_fields(const std::string& bytes);

/// Where the structures of an HDF5 file begin: superblock, object headers, trees, heaps, symbol tables.
/// Source: HDF5 File Format Specification, version 3.
std::vector<std::size_t> find_hdf5_structures(const std::string& bytes);

/// Sets the checksums of superblock and object headers to what their bytes ask for, so that HDF5 looks
/// further.
void mend_hdf5_checksums(std::string& bytes);

/// The checksum of HDF5's metadata: Jenkins' lookup3, hashlittle with the initial value 0.
std::uint32_t hdf5_checksum(const std::string& bytes, std::size_t begin, std::size_t n);

}  // namespace contactsim::test
