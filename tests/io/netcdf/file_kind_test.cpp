// SPDX-License-Identifier: BSD-3-Clause
#include "io/netcdf/file_kind.hpp"

#include <sys/stat.h>

#include "core/base/errors.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

// What is said of a file with these bytes.
std::string refusal_of(const std::string& bytes) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("mesh.g");
  write_bytes(path, bytes);
  Diagnostics warnings;
  try {
    read_mesh(path, warnings);
  } catch (const FileError& error) {
    return std::string(error.what()).substr(path.size() + 2);
  }
  return "";
}

}  // namespace

TEST_CASE("what is no mesh is called what it is", "[io][file]") {
  CHECK(refusal_of("") == "is empty (0 bytes), not an Exodus mesh");
  CHECK(refusal_of("begin sierra\n  # a deck\nend\n") == "is a text file, not an Exodus mesh");
  CHECK(refusal_of("gr\xc3\xbc\xc3\x9f") == "is a text file, not an Exodus mesh");
  CHECK(refusal_of("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12\n") ==
        "is a git-lfs pointer, not the mesh itself; fetch the mesh with 'git lfs pull'");
  CHECK(refusal_of(std::string("PK\x03\x04\0\0\0\0", 8)) ==
        "is not a netCDF or Exodus file (NetCDF: Unknown file format)");
  CHECK(refusal_of("\x89HDF\r\n\x1a\n" + std::string(200, '\0')) ==
        "damaged or truncated HDF5 file (NetCDF: HDF error)");
}

TEST_CASE("what cannot be opened is distinguished", "[io][file]") {
  const TemporaryDirectory directory;
  const auto message = [&](const std::string& path) -> std::string {
    try {
      find_file_kind(path);
    } catch (const FileError& error) {
      return std::string(error.what()).substr(path.size() + 2);
    }
    return "";
  };
  CHECK(message(directory.file("missing.g")) == "no such file");
  CHECK(message(directory.file(".")) == "is a directory, not an Exodus mesh");
  CHECK(message("") == "no such file");
  const std::string pipe = directory.file("pipe");
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(message(pipe) == "is not a regular file");
  const std::string below_file = directory.file("file/mesh.g");
  write_bytes(directory.file("file"), "x");
  CHECK(!message(below_file).empty());
}

TEST_CASE("netCDF formats are known by their first bytes", "[io][file]") {
  const TemporaryDirectory directory;
  write_bytes(directory.file("a"), std::string("CDF\x02\0\0\0\0", 8));
  write_bytes(directory.file("b"), "\x89HDF\r\n\x1a\n");
  write_bytes(directory.file("c"), std::string("\0\0", 2));
  CHECK(find_file_kind(directory.file("a")) == FileKind::classic);
  CHECK(find_file_kind(directory.file("b")) == FileKind::hdf5);
  CHECK(find_file_kind(directory.file("c")) == FileKind::other);
}
