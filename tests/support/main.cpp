// SPDX-License-Identifier: BSD-3-Clause
// Compiled once for all test programs: Catch2 is slow to build.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
