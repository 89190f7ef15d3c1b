// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/file_descriptor.hpp"

#include <fcntl.h>

#include "support/catch.hpp"

using contactsim::FileDescriptor;

TEST_CASE("a descriptor is closed with its owner, or before", "[io][files]") {
  CHECK_FALSE(FileDescriptor().is_open());
  int number = -1;
  {
    FileDescriptor file(open("/dev/null", O_RDONLY | O_CLOEXEC));
    REQUIRE(file.is_open());
    number = file.number();
    CHECK(fcntl(number, F_GETFD) >= 0);
  }
  CHECK(fcntl(number, F_GETFD) < 0);
  FileDescriptor file(open("/dev/null", O_RDONLY | O_CLOEXEC));
  number = file.number();
  file.close();
  CHECK_FALSE(file.is_open());
  CHECK(fcntl(number, F_GETFD) < 0);
  file.close();
}
